// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/pieces/ChangePiece.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowDeeds.h"
#include "core/edits/answers/RowFacts.h"

#include <cmath>

namespace core {

using namespace rowWords;

Result<void> check(const ChangePiece& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const ChangePiece& edit, Document& document)
{
    Piece* piece = document.piece(edit.piece);
    if (!piece)
        return unknownPiece("changePiece.piece", edit.piece);
    bool changed = assign(piece->name, edit.name);
    changed |= assign(piece->pose.offsetMm, edit.offsetMm);
    changed |= assign(piece->pose.rotationDegrees, edit.rotationDegrees);
    changed |= assign(piece->pose.zoom, edit.zoom);
    return changed;
}

EditEffects effects(const ChangePiece&)
{
    return documentEffects(DocumentChange::What::Pieces);
}

RowTitle rowTitle(const ChangePiece& edit, const RowFacts& row)
{
    const Document& document = row.document;
    const Piece* piece = document.piece(edit.piece);
    const QString name = pieceName(edit.piece, document);
    Deeds deeds;
    if (differs(edit.name, piece ? &piece->name : nullptr))
        deeds.add({.code = RowTitleCode::RenamePiece, .arguments = {name, *edit.name}}, {});
    const PiecePose before = piece ? piece->pose : PiecePose();
    const PiecePose pose{.offsetMm = edit.offsetMm.value_or(before.offsetMm),
        .rotationDegrees = edit.rotationDegrees.value_or(before.rotationDegrees),
        .zoom = edit.zoom.value_or(before.zoom)};
    if (pose == before)
        return deeds.title();
    if (pose.isHome()) {
        deeds.add({.code = RowTitleCode::SendPieceHome, .arguments = {name}},
            {.code = RowTitleCode::SendItHome});
        return deeds.title();
    }
    // What it differs in from where it was: that is what the hand did.
    if (pose.offsetMm != before.offsetMm) {
        const TitleArgument far = inMm(glm::length(pose.offsetMm));
        deeds.add({.code = RowTitleCode::MovePiece, .arguments = {name, far}},
            {.code = RowTitleCode::MoveIt, .arguments = {far}});
    }
    if (pose.rotationDegrees != before.rotationDegrees) {
        const TitleArgument angle = TitleNumber{std::lround(glm::length(pose.rotationDegrees))};
        deeds.add({.code = RowTitleCode::TurnPiece, .arguments = {name, angle}},
            {.code = RowTitleCode::TurnIt, .arguments = {angle}});
    }
    if (pose.zoom != before.zoom) {
        const TitleArgument factor = TitleDigits{.value = pose.zoom, .digits = 3};
        deeds.add({.code = RowTitleCode::ZoomPiece, .arguments = {name, factor}},
            {.code = RowTitleCode::ZoomIt, .arguments = {factor}});
    }
    return deeds.title();
}

EditDependencies dependencies(const ChangePiece&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

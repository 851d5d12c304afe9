// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/pieces/ChangePiece.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
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

QString rowName(const ChangePiece& edit, const RowFacts& row)
{
    const Document& document = row.document;
    const Piece* piece = document.piece(edit.piece);
    const QString name = pieceName(edit.piece, document);
    Deeds deeds;
    if (differs(edit.name, piece ? &piece->name : nullptr))
        deeds.add(QStringLiteral("Rename piece %1 to %2").arg(name, quoted(*edit.name)), {});
    const PiecePose before = piece ? piece->pose : PiecePose();
    const PiecePose pose{.offsetMm = edit.offsetMm.value_or(before.offsetMm),
        .rotationDegrees = edit.rotationDegrees.value_or(before.rotationDegrees),
        .zoom = edit.zoom.value_or(before.zoom)};
    if (pose == before)
        return deeds.text();
    if (pose.isHome()) {
        deeds.add(QStringLiteral("Send piece %1 home").arg(name), QStringLiteral("send it home"));
        return deeds.text();
    }
    // What it differs in from where it was: that is what the hand did.
    if (pose.offsetMm != before.offsetMm) {
        const QString far = millimetres(glm::length(pose.offsetMm));
        deeds.add(
            QStringLiteral("Move piece %1 %2").arg(name, far), QStringLiteral("move it ") + far);
    }
    if (pose.rotationDegrees != before.rotationDegrees) {
        const QString angle =
            QString::number(std::lround(glm::length(pose.rotationDegrees))) + QStringLiteral("°");
        deeds.add(QStringLiteral("Turn piece %1 %2").arg(name, angle),
            QStringLiteral("turn it ") + angle);
    }
    if (pose.zoom != before.zoom) {
        const QString factor = QString::number(pose.zoom, 'g', 3) + QStringLiteral("×");
        deeds.add(QStringLiteral("Zoom piece %1 %2").arg(name, factor),
            QStringLiteral("zoom it ") + factor);
    }
    return deeds.text();
}

EditReach reach(const ChangePiece&, const ReachFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

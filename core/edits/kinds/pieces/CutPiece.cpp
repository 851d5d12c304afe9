// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/pieces/CutPiece.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/pieces/AppendPiece.h"

namespace core {

using namespace rowWords;

Result<void> check(const CutPiece& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const CutPiece& edit, Document& document)
{
    const SculptLayer* layer = document.layer(edit.layer);
    if (!layer)
        return unknownLayer("cutPiece.layer", edit.layer);
    if (const Piece* other = document.pieceOfLayer(edit.layer))
        return failure(ErrorCode::InvalidField, QStringLiteral("cutPiece.layer"),
            Clause::saying(
                "sculpt layer '%1' is the piece '%2' already", layer->name, other->name));
    return appendPiece(
        {.name = edit.name, .layer = edit.layer, .pivotLps = edit.pivotLps}, "cutPiece", document);
}

EditEffects effects(const CutPiece& edit)
{
    return documentEffects(DocumentChange::What::Pieces, edit.pivotLps.has_value());
}

RowTitle rowTitle(const CutPiece& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::LiftPiece,
        .arguments = {edit.name, layerName(edit.layer, row.document)}};
}

EditDependencies dependencies(const CutPiece&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/pieces/SendPiecesHome.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"

namespace core {

Result<void> check(const SendPiecesHome& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const SendPiecesHome&, Document& document)
{
    bool changed = false;
    for (Piece& piece : document.pieces) {
        changed |= !piece.pose.isHome();
        piece.pose = {};
    }
    return changed;
}

EditEffects effects(const SendPiecesHome&)
{
    return documentEffects(DocumentChange::What::Pieces);
}

RowTitle rowTitle(const SendPiecesHome&, const RowFacts&)
{
    return {.code = RowTitleCode::SendPiecesHome};
}

EditDependencies dependencies(const SendPiecesHome&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

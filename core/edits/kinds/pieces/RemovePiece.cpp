// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/pieces/RemovePiece.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"

namespace core {

using namespace rowWords;

Result<void> check(const RemovePiece& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const RemovePiece& edit, Document& document)
{
    if (!document.piece(edit.piece))
        return unknownPiece("removePiece.piece", edit.piece);
    removePieces(document, [&edit](const Piece& each) { return each.id == edit.piece; });
    return true;
}

EditEffects effects(const RemovePiece&)
{
    return documentEffects(DocumentChange::What::Pieces);
}

RowTitle rowTitle(const RemovePiece& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::RemovePiece, .arguments = {pieceName(edit.piece, row.document)}};
}

EditDependencies dependencies(const RemovePiece&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

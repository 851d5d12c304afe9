// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/pieces/AppendPiece.h"

#include <utility>

namespace core {

namespace {

constexpr int mostPieces = 64; // what one ray can meet (gpu/render)

} // namespace

Result<bool> appendPiece(Piece piece, const char* edit, Document& document)
{
    if (std::ssize(document.pieces) >= mostPieces)
        return failure(ErrorCode::InvalidField, QLatin1String(edit),
            Clause::saying("there are at most %1 pieces", mostPieces));
    piece.id = document.lastPieceGiven() + 1;
    document.pieces.push_back(std::move(piece));
    return true;
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/edits/answers/ListEdits.h"

namespace core {

tl::unexpected<Error> unknownSegment(int label)
{
    return failure(ErrorCode::UnknownSegment, QString::number(label));
}

tl::unexpected<Error> unknownLayer(const char* field, int id)
{
    return failure(ErrorCode::InvalidField, QLatin1String(field),
        Clause::saying("there is no sculpt layer %1", id));
}

tl::unexpected<Error> unknownPiece(const char* field, int id)
{
    return failure(
        ErrorCode::InvalidField, QLatin1String(field), Clause::saying("there is no piece %1", id));
}

void removeLayer(const SculptLayer* layer, Document& document)
{
    document.greatestRemovedLayer = std::max<int>(document.greatestRemovedLayer, layer->id);
    removePieces(document, [id = layer->id](const Piece& piece) { return piece.layer == id; });
    document.layers.erase(document.layers.begin() + (layer - document.layers.data()));
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

namespace core {

// Parts from which apply() of several edits is made: changes of the document's lists.

[[nodiscard]] tl::unexpected<Error> unknownSegment(int label);
/// @param field named in the error
[[nodiscard]] tl::unexpected<Error> unknownLayer(const char* field, int id);
[[nodiscard]] tl::unexpected<Error> unknownPiece(const char* field, int id);

/// Assigns a value if it is given and differs. @return whether it did
template <class T> bool assign(T& target, const std::optional<T>& value)
{
    if (!value || target == *value)
        return false;
    target = *value;
    return true;
}

/// Moves an element of a list to a place counted from 1. @return whether it moved
template <class T>
bool moveTo(std::vector<T>& list, typename std::vector<T>::iterator from, int place)
{
    const auto to = list.begin() + (std::min<std::ptrdiff_t>(place, std::ssize(list)) - 1);
    if (from < to)
        std::rotate(from, from + 1, to + 1);
    else
        std::rotate(to, from, from + 1);
    return from != to;
}

/// Removes pieces. Measurements on them are kept, at their true places.
template <class Which> void removePieces(Document& document, const Which& which)
{
    for (const Piece& piece : document.pieces) {
        if (!which(piece))
            continue;
        document.greatestRemovedPiece = std::max(document.greatestRemovedPiece, piece.id);
        for (Measurement& measurement : document.measurements) {
            if (measurement.piece == piece.id)
                measurement.piece = 0;
        }
    }
    std::erase_if(document.pieces, which);
}

/// Removes a layer of the document with its pieces.
void removeLayer(const SculptLayer* layer, Document& document);

} // namespace core

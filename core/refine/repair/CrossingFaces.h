// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

#include <functional>
#include <vector>

namespace core {

/// Two faces that pass through each other; if both are the same, the face passes through itself.
struct CrossingFaces {
    FaceId one = noId; ///< not greater than `other`
    FaceId other = noId;
    bool operator==(const CrossingFaces&) const = default;
    auto operator<=>(const CrossingFaces&) const = default;
};

/// Searches a number of items on several threads, if there are enough of them, and collects the
/// pairs that were found: ascending, each once, independent of the number of threads.
/// @param places number of items
/// @param look searches the items from begin to before end and appends what it finds; a pair may be
/// found more than once
[[nodiscard]] std::vector<CrossingFaces> collectCrossings(std::size_t places,
    const std::function<void(
        std::size_t begin, std::size_t end, std::vector<CrossingFaces>& found)>& look);

} // namespace core

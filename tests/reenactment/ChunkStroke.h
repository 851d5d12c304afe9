// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkMap.h"
#include "tests/reenactment/UserEye.h"

namespace reenact {

/// A click on a chunk, or a stroke over several on a slice.
struct ChunkStroke {
    int division = 0; ///< into how many chunks
    bool adds = false;
    std::vector<glm::dvec3> points; ///< index; between them the stroke runs straight
    int gain = 0; ///< voxels that are right afterwards, less those spoilt
};

/// The stroke that mends most, at any place of the slider or at a given one: it goes over chunks of
/// which more is wrong than right, and leaves those in peace that it would pass needlessly.
/// @param division 0: any
[[nodiscard]] ChunkStroke bestChunkStroke(
    const core::ChunkMap& map, const UserEye& eye, int division);

/// Places close enough together on a stroke that it misses no chunk.
[[nodiscard]] std::vector<glm::dvec3> alongStroke(const std::vector<glm::dvec3>& points);

} // namespace reenact

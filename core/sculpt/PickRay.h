// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace core {

/// Which point along a ray counts as visible to the user.
enum class SeenBy : std::uint8_t {
    Surface, ///< first sample that is material (CutFrame.h rule 3)
    Opacity, ///< first sample where accumulated opacity reaches one half
    BrightestVoxel, ///< greatest interpolated value along the ray; the first of equals
    Segment, ///< first sample in a voxel of some segments, carved or not
};

/// A ray as a row of samples through the volume, to find the voxel that the user sees.
struct PickRay {
    glm::ivec3 origin{0}; ///< index16 at sample 0
    glm::ivec3 step{0}; ///< index16 per sample
    int samples = 0;
};

} // namespace core

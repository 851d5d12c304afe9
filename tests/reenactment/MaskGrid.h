// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "tests/support/scenes/TestVolumes.h"

#include <vector>

namespace reenact {

using Mask = test::Bytes; ///< 0 or 1
using Field = reference::DenseArray<float>;

[[nodiscard]] core::VoxelRuns runsOf(const Mask& mask);
[[nodiscard]] Mask maskOf(const core::VoxelRuns& runs, const glm::ivec3& size);
[[nodiscard]] std::size_t countOf(const Mask& mask);
/// Voxels in which they differ.
[[nodiscard]] std::size_t differing(const Mask& one, const Mask& other);

/// How far each voxel's centre is from the nearest one that is set, in voxels; exact.
[[nodiscard]] Field distanceTo(const Mask& mask);
/// To the border between inside and outside, half a voxel from centres beside it: negative inside.
[[nodiscard]] Field signedDistance(const Mask& mask);
/// A mask made smooth, 0 … 1; ½ is its border.
[[nodiscard]] Field smoothed(const Mask& mask);
/// Linear between centres; beyond the grid as at its rim.
[[nodiscard]] double sampled(const Field& field, const glm::dvec3& index);

/// A part of a mask that hangs together over faces.
struct MaskPart {
    std::vector<glm::ivec3> voxels;
    double radius = 0.0; ///< voxels: of the greatest ball in it
    glm::ivec3 deepest{0}; ///< the middle of that
};
[[nodiscard]] std::vector<MaskPart> partsOf(const Mask& mask);

} // namespace reenact

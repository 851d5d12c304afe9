// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/volume/VolumeGeometry.h"

#include <span>
#include <vector>

namespace test {

/// Returns the voxels that an edit of islands is about, one bit per voxel of the volume. It is
/// found by flood fill, one part after the other; core joins runs of voxels instead.
/// @param labels of the segment's plane, x fastest
[[nodiscard]] std::vector<bool> islandVoxels(const core::CleanSegment& edit,
    const core::VolumeGeometry& geometry, std::span<const std::uint8_t> labels);

/// Returns the islands of a segment, largest first, each as indices of its voxels. Of islands of
/// equal size the one with the lowest index comes first.
[[nodiscard]] std::vector<std::vector<std::size_t>> islandsBySize(
    const glm::ivec3& size, std::span<const std::uint8_t> labels, int segment);

} // namespace test

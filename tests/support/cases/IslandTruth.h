// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/volume/VolumeGeometry.h"

#include <span>
#include <vector>

namespace test {

/// Which voxels of the whole volume a rule of islands is about, found by filling part by part,
/// where core joins runs of voxels.
/// @param labels of the segment's plane, x fastest
[[nodiscard]] std::vector<bool> islandVoxels(const core::CleanSegment& edit,
    const core::VolumeGeometry& geometry, std::span<const std::uint8_t> labels);

/// The islands of a segment from the largest down, each by the places of its voxels; of equal ones
/// the first in memory comes first.
[[nodiscard]] std::vector<std::vector<std::size_t>> islandsBySize(
    const glm::ivec3& size, std::span<const std::uint8_t> labels, int segment);

} // namespace test

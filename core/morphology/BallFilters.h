// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

struct MillimetreBall;

// What a ball does to a mask, exactly and in whole numbers. dilate() and keepMajority() work in
// place and on all cores, need at most filterBytes(), and check every few milliseconds whether they
// were cancelled; then they fail with Cancelled, and the mask is undefined. Any thread outside a
// parallelFor().

/// A mask of the voxels of a box, x fastest: 1 or 0. Voxels outside the box do not belong to it.
struct ByteMask {
    glm::ivec3 size{0};
    std::vector<std::uint8_t> voxels;
};

/// Memory for a mask of this size and one filter that works on it: three bytes per voxel, and what
/// is needed for single rows and slices.
[[nodiscard]] double filterBytes(const glm::ivec3& size);

/// Which stage of longer work a filter is, so that it can report its progress.
struct FilterStage {
    const Progress& progress;
    int number = 0; ///< number of this stage, from 0
    int of = 1;
};

/// Sets every voxel that has a voxel of the mask in the ball around it. On a grid with axes at
/// right angles the cost does not depend on the size of the ball (MaskDilation.h). On a sheared
/// grid the mask's voxels in the ball are counted, at the cost of keepMajority().
[[nodiscard]] Result<void> dilate(
    ByteMask& mask, const MillimetreBall& ball, const FilterStage& stage);

/// Sets exactly those voxels for which more than half of the ball's voxels around them are in the
/// mask; of a flat ball those that it has (MillimetreBall::isFlat). The box has a single voxel
/// along such an axis. Cost ∝ voxels of the box × rows of the ball.
[[nodiscard]] Result<void> keepMajority(
    ByteMask& mask, const MillimetreBall& ball, const FilterStage& stage);

/// Sets every voxel from which no path over faces of unset voxels leads to the border of the box.
/// @param progress only checked for cancellation
[[nodiscard]] Result<void> fillEnclosed(ByteMask& mask, const Progress& progress);

} // namespace core

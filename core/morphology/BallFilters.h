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

// What a ball does to a mask, exactly and in whole numbers. Both work in place and on all cores,
// ask every few milliseconds whether they were cancelled (then they fail with Cancelled, and the
// mask is undefined), and need filterBytes() at most. Any thread that is no parallelFor's.

/// Voxels of a box, x fastest: 1 or 0. What lies beyond the box is no voxel.
struct ByteMask {
    glm::ivec3 size{0};
    std::vector<std::uint8_t> voxels;
};

/// Memory for a mask of that size and one filter at work: three bytes a voxel, and what is needed
/// for single rows and slices.
[[nodiscard]] double filterBytes(const glm::ivec3& size);

/// A filter's place in longer work, for its progress.
struct FilterStage {
    const Progress& progress;
    int number = 0; ///< from 0
    int of = 1;
};

/// Sets every voxel that has one of the mask in the ball around it. On a grid with axes at right
/// angles its cost does not depend on the ball: squared distances are worked out along rows, then
/// by lower envelopes of parabolas along columns, and each voxel reaches so many slices. On a
/// sheared grid the voxels of the ball are counted as below.
[[nodiscard]] Result<void> dilate(
    ByteMask& mask, const MillimetreBall& ball, const FilterStage& stage);

/// Sets the voxels with more than half of the whole ball around them in the mask, and no other.
/// Cost ∝ voxels of the box × rows of the ball.
[[nodiscard]] Result<void> keepMajority(
    ByteMask& mask, const MillimetreBall& ball, const FilterStage& stage);

/// Sets every voxel from which no way over faces of unset ones leads to the border of the box.
/// @param progress is only asked whether it was cancelled
[[nodiscard]] Result<void> fillEnclosed(ByteMask& mask, const Progress& progress);

} // namespace core

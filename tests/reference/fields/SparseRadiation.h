// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/radiation/SparseRadiation.h"
#include "tests/reference/fields/DenseFields.h"

#include <span>

namespace reference {

/// A point and what it marks.
struct SparsePoint {
    core::radiation::SparseFootprint footprint;
    std::uint8_t label = 0;
};

/// The sums of all footprints in a box, before the clamp, and whose part is the greatest there
/// (of equal ones the greatest label; 0 where nothing reaches).
struct SparseField {
    DenseArray<std::uint32_t> sums;
    DenseArray<std::uint8_t> labels;
};

/// @param origin voxel of the box's first
[[nodiscard]] SparseField sparseRadiation(
    std::span<const SparsePoint> points, const glm::ivec3& origin, const glm::ivec3& size);

} // namespace reference

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// A half-space that a clip plane or a side of the clip box hides from a cut, in integers. It hides
/// an index position p if perVoxel · p > offset: for a voxel (i, j, k) this is computed in plain
/// 64-bit integers; for a position in index16 (p · 2¹⁶) it is perVoxel · p − offset · 2¹⁶ > 0. A
/// position is hidden if any half-space hides it.
struct IntegerHalfSpace {
    glm::ivec3 perVoxel{0}; ///< |component| ≤ 2²⁰
    std::int64_t offset = 0; ///< |offset| ≤ 2⁴⁰
    bool operator==(const IntegerHalfSpace&) const = default;
};

/// Whether every number is in the range that the rules allow; at most 16 half-spaces are.
[[nodiscard]] bool isSound(const std::vector<IntegerHalfSpace>& hidden);

/// The samples of a ray that are visible: first ≤ n < end.
struct SeenSamples {
    int first = 0;
    int end = 0;
};
/// @param origin, step in index16, |origin| ≤ 2³⁰
/// @param count number of samples of the ray
[[nodiscard]] SeenSamples seenSamples(const std::vector<IntegerHalfSpace>& hidden,
    const glm::ivec3& origin, const glm::ivec3& step, int count);

/// Of samples of a ray those whose nearest voxel lies in a box.
[[nodiscard]] SeenSamples samplesWithin(const SeenSamples& samples, const glm::ivec3& origin,
    const glm::ivec3& step, const VoxelBox& box);

/// For each half-space, perVoxel · p − offset at a brick's first voxel, clamped to ±2³⁰. For the
/// voxels of the brick the value differs from that by an amount that fits 32 bits.
[[nodiscard]] std::vector<std::int32_t> hiddenBase(
    const std::vector<IntegerHalfSpace>& hidden, const glm::ivec3& firstVoxel);

} // namespace core

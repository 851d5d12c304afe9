// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// One side of a plane that a cut did not see, in integers. An index position p is hidden by it
/// where perVoxel · p > offset: of a voxel (i, j, k) in plain 64-bit integers, of a position in
/// index16 (p · 2¹⁶) where perVoxel · p − offset · 2¹⁶ > 0. What one of them hides is hidden.
struct HiddenHalf {
    glm::ivec3 perVoxel{0}; ///< |component| ≤ 2²⁰
    std::int64_t offset = 0; ///< |offset| ≤ 2⁴⁰
    bool operator==(const HiddenHalf&) const = default;
};

/// Whether every number is one that the rules allow; at most 16 of them.
[[nodiscard]] bool isSound(const std::vector<HiddenHalf>& hidden);

/// The samples of a ray that are not hidden: first ≤ n < end.
struct SeenSamples {
    int first = 0;
    int end = 0;
};
/// @param origin, step in index16, |origin| ≤ 2³⁰; @param count samples that the ray has
[[nodiscard]] SeenSamples seenSamples(const std::vector<HiddenHalf>& hidden,
    const glm::ivec3& origin, const glm::ivec3& step, int count);

/// How far a brick's first voxel lies in each hidden half, perVoxel · p − offset, no farther than
/// ±2³⁰: voxels of the brick differ from it by what 32 bits hold.
[[nodiscard]] std::vector<std::int32_t> hiddenBase(
    const std::vector<HiddenHalf>& hidden, const glm::ivec3& firstVoxel);

} // namespace core

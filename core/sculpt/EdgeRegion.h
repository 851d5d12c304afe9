// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CapsuleSweep.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

namespace core {

/// How a brush follows edges (the adaptive brush): of the voxels that it sweeps, it changes only
/// those that resemble the place where the stroke began and are connected with where the pen was.
/// Both engines follow these rules exactly.
///
/// 1. Value. Among the voxels whose index differs from `start` by at most 1 in each component,
///    those count that lie in the volume and, for a flat brush, in its slab (CapsuleSweep.h, rule
///    2); `start` itself always counts. The value is the lower median of their n codes: the code at
///    place ⌊(n − 1) / 2⌋ of the ascending list, counted from 0. It holds for the whole stroke.
/// 2. A voxel is alike if the edit may change a voxel with its code at all, and if it is inside a
///    capsule of the stroke (CapsuleSweep.h, rule 4) for which its code differs from the value by
///    at most ⌊tolerance · strength / 255⌋.
/// 3. A member is an alike voxel under the pen (CapsulePath::under), or an alike voxel that can be
///    reached from there in steps through alike voxels. For a ball or cube a step changes one
///    component of the index by 1. A flat brush is one voxel thick along its main axis
///    (steepestAxis()). There a step changes the component along the main axis by at most 1 and at
///    most one of the others by 1: so an oblique plane is connected, while no step leads through a
///    wall of one voxel.
///
/// Members depend on the image and the path alone, not on any label, and each further capsule can
/// only add members. So neither the order of capsules nor the division of a stroke into pieces
/// matters: added piece by piece, it gives the same as all at once.
struct EdgeRule {
    glm::ivec3 start{0}; ///< index of the voxel in which the stroke begins
    std::int32_t tolerance = 0; ///< greatest difference from the value, in codes
};

/// Whether its numbers are in the ranges that the rules allow.
[[nodiscard]] bool isSound(const EdgeRule& rule, const BrickGrid& grid);

/// The box around the start whose codes rule 1 needs; cut to the volume.
[[nodiscard]] VoxelBox edgeValueBox(const EdgeRule& rule, const BrickGrid& grid);
/// The value of a stroke (rule 1).
/// @param codes one for each voxel of edgeValueBox(), x fastest
[[nodiscard]] int edgeValue(const EdgeRule& rule, const CapsuleFrame& frame, const BrickGrid& grid,
    std::span<const std::uint16_t> codes);

/// Finds the members of one stroke while the pen is down (rule 3). The cost follows what is added;
/// each voxel is visited once.
class EdgeRegion {
public:
    /// One bit for each voxel of a brick: that of offset o is bit o mod 32 of word o / 32.
    using Bits = std::array<std::uint32_t, BrickGrid::voxelsPerBrick / 32>;

    EdgeRegion(const CapsuleFrame& frame, const BrickGrid& grid);

    /// Adds alike voxels of a brick. No bit may be set for voxels outside the volume.
    void addAlike(std::uint32_t brick, const Bits& alike);
    /// Adds voxels under the pen. Those outside the volume are ignored.
    void addUnder(const std::vector<glm::ivec3>& voxels);
    /// The members that were added since the last call, by brick; bricks without any are left out.
    [[nodiscard]] std::map<std::uint32_t, Bits> takeNew();

private:
    struct Brick {
        Bits alike{};
        Bits under{};
        Bits members{};
    };
    [[nodiscard]] bool isMember(const glm::ivec3& voxel);
    /// Makes a voxel a member if it is alike and no member yet.
    void reach(const glm::ivec3& voxel);
    /// The brick of a voxel; null if nothing was added to it.
    [[nodiscard]] Brick* brickAt(const glm::ivec3& voxel);

    BrickGrid m_grid;
    std::vector<glm::ivec3> m_steps;
    std::unordered_map<std::uint32_t, Brick> m_bricks;
    std::map<std::uint32_t, Bits> m_new;
    std::vector<glm::ivec3> m_front; ///< members whose neighbours have not been examined yet
    std::uint32_t m_lastNumber = ~0u; ///< number of the brick that was asked for last
    Brick* m_last = nullptr;
};

} // namespace core

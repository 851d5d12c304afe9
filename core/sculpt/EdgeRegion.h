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

/// How a brush follows edges (the adaptive brush): of what it sweeps it takes only voxels that are
/// alike and joined to where the pen was. Both engines follow these rules exactly.
///
/// 1. Value. Of the voxels whose index differs from `start` by at most 1 in each component, those
///    count that lie in the volume and, for a flat brush, in its slab (CapsuleSweep.h, rule 2);
///    `start` itself always does. The value is the lower median of their n codes: the code at place
///    ⌊(n − 1) / 2⌋ of the ascending list, counted from 0. It holds for the whole stroke.
/// 2. A voxel is alike if its code is one that the edit may change at all, and it is inside a
///    capsule of the stroke (CapsuleSweep.h, rule 4) whose tolerance, ⌊tolerance · strength / 255⌋,
///    its difference from the value does not exceed.
/// 3. A member is an alike voxel under the pen (CapsulePath::under), or one that steps through
///    alike voxels lead to from there. For a ball or cube a step changes one component of the index
///    by 1. A flat brush is one voxel thick along its main axis, the one of which |perI.z|,
///    |perJ.z| or |perK.z| (strokeStep()) is the greatest, the first of equals; there a step
///    changes the component along the main axis by at most 1 and at most one of the others by 1, so
///    that an oblique plane holds together while no step leads through a wall of one voxel.
///
/// Members follow from the image and the path alone, not from any label, and each further capsule
/// can only add some. So neither the order of capsules nor how a stroke is split matters: what is
/// told piece by piece comes to the same as all at once.
struct EdgeRule {
    glm::ivec3 start{0}; ///< the voxel in which the stroke begins
    std::int32_t tolerance = 0; ///< codes
};

/// Whether its numbers are in the range that the rules allow.
[[nodiscard]] bool isSound(const EdgeRule& rule, const BrickGrid& grid);

/// The box around the start of which rule 1 asks the codes; within the volume.
[[nodiscard]] VoxelBox edgeValueBox(const EdgeRule& rule, const BrickGrid& grid);
/// Rule 1. @param codes of that box, x fastest
[[nodiscard]] int edgeValue(const EdgeRule& rule, const CapsuleFrame& frame, const BrickGrid& grid,
    std::span<const std::uint16_t> codes);

/// The members of one stroke while the pen is down (rule 3). Its cost follows what is added; each
/// voxel is passed once.
class EdgeRegion {
public:
    /// A bit for each voxel of a brick: of offset o bit o mod 32 of word o / 32.
    using Bits = std::array<std::uint32_t, BrickGrid::voxelsPerBrick / 32>;

    EdgeRegion(const CapsuleFrame& frame, const BrickGrid& grid);

    /// These voxels are alike; of voxels outside the volume no bit is set.
    void addAlike(std::uint32_t brick, const Bits& alike);
    /// The pen was here. Voxels outside the volume count for nothing.
    void addUnder(const std::vector<glm::ivec3>& voxels);
    /// The members that there were not at the last call, by brick; bricks without any are left out.
    [[nodiscard]] std::map<std::uint32_t, Bits> takeNew();

private:
    struct Brick {
        Bits alike{};
        Bits under{};
        Bits members{};
    };
    [[nodiscard]] bool isMember(const glm::ivec3& voxel);
    /// Makes it a member if it is alike and was none.
    void reach(const glm::ivec3& voxel);
    /// Null where nothing is known of it.
    [[nodiscard]] Brick* brickAt(const glm::ivec3& voxel);

    BrickGrid m_grid;
    std::vector<glm::ivec3> m_steps;
    std::unordered_map<std::uint32_t, Brick> m_bricks;
    std::map<std::uint32_t, Bits> m_new;
    std::vector<glm::ivec3> m_front; ///< members whose neighbours have not been looked at
    std::uint32_t m_lastNumber = ~0u; ///< of the brick that was asked for last
    Brick* m_last = nullptr;
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

// What passes between sculpt layers and segments, in integers. Both engines follow the rules to the
// bit; each voxel decides for itself, so neither order nor company matters.

/// Index positions with normal · voxel ≤ offset.
struct VoxelBound {
    /// |normal[axis]| · size[axis] < 2²⁹ on each axis of the volume, so that no sum overflows.
    glm::ivec3 normal{0};
    std::int32_t offset = 0;
    bool operator==(const VoxelBound&) const = default;
};

/// Give a label to voxels. A voxel that is chosen, and that the plane holds 0, the label or a label
/// in `overwritable` at, receives the label; a seed word there that bears another label (a member's
/// or a pending seed's) becomes unvisited. So no growth goes on from what this took, and none
/// counts it as its own.
struct LabelTarget {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    std::bitset<256> overwritable{};
};

/// Chosen: coverage of the layer ≥ 128, muted or not.
struct LabelCarved {
    LabelTarget target{};
    std::uint8_t layer = 0;
};

/// Chosen: what is seen, from wherever: coverage < 128 in all layers that are not muted, lowCode ≤
/// code ≤ highCode, and within every bound.
struct LabelSeen {
    LabelTarget target{};
    int lowCode = 0;
    int highCode = 65535;
    std::vector<VoxelBound> bounds{};
};

/// Give labels to voxels that are listed. Each by the rule of LabelTarget, with the label that is
/// asked for it; where 0 is asked nothing happens.
struct LabelListed {
    struct Brick {
        std::uint32_t brick = 0;
        std::vector<std::uint8_t> labels; ///< of its 4096 voxels
    };
    std::uint8_t plane = 0;
    std::bitset<256> overwritable{};
    std::vector<Brick> bricks{}; ///< ascending, each once
};

/// Give a label to voxels that are listed, and take it from others. One that is to receive it goes
/// by the rule of LabelTarget. One that is to lose it becomes 0 where the plane holds the label at
/// it, and a seed word there that bears the label becomes unvisited (as PaintLabel erases).
struct RelabelListed {
    static constexpr std::uint8_t give = 1;
    static constexpr std::uint8_t take = 2;
    struct Brick {
        std::uint32_t brick = 0;
        std::vector<std::uint8_t> asked; ///< of its 4096 voxels: give, take or 0, which is nothing
    };
    LabelTarget target{};
    std::vector<Brick> bricks{}; ///< ascending, each once
};

/// Coverage of the layer = 255 wherever the plane holds the label.
struct CoverLabel {
    std::uint8_t layer = 0;
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
};

/// Empty a layer. With `into`, another one: there coverage = max(coverage, that of the layer).
struct FoldLayer {
    std::uint8_t layer = 0;
    std::optional<std::uint8_t> into{};
};

/// Whether listed bricks are whole, ascend and are the volume's.
template <class Brick>
[[nodiscard]] bool areSound(
    const std::vector<Brick>& bricks, std::vector<std::uint8_t> Brick::*voxels, int brickCount)
{
    std::int64_t last = -1;
    for (const Brick& brick : bricks) {
        if ((brick.*voxels).size() != 4096 || std::int64_t(brick.brick) <= last
            || std::int64_t(brick.brick) >= brickCount)
            return false;
        last = brick.brick;
    }
    return true;
}

[[nodiscard]] inline bool isSound(const LabelListed& edit, int brickCount)
{
    return areSound(edit.bricks, &LabelListed::Brick::labels, brickCount);
}

/// Also whether nothing else is asked for than it knows.
[[nodiscard]] inline bool isSound(const RelabelListed& edit, int brickCount)
{
    for (const RelabelListed::Brick& brick : edit.bricks) {
        for (const std::uint8_t asked : brick.asked) {
            if (asked > RelabelListed::take)
                return false;
        }
    }
    return areSound(edit.bricks, &RelabelListed::Brick::asked, brickCount);
}

/// Whether every normal is short enough for a volume of this size.
[[nodiscard]] inline bool areSound(const std::vector<VoxelBound>& bounds, const glm::ivec3& size)
{
    for (const VoxelBound& bound : bounds) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t reach = std::int64_t(bound.normal[axis]) * size[axis];
            if (reach <= -(std::int64_t(1) << 29) || reach >= std::int64_t(1) << 29)
                return false;
        }
    }
    return true;
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/TypeList.h"
#include "core/brick/BrickGrid.h"
#include "core/sculpt/labels/EditableVoxels.h"

#include <glm/glm.hpp>

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

// Commands that carry over voxels between sculpt layers and segments, or list voxels; every number
// is an integer. Both engines follow the rules to the bit. Each voxel is decided independently of
// the others.

/// A half-space that contains the index positions with normal · voxel ≤ offset.
struct VoxelBound {
    /// |normal[axis]| · size[axis] < 2²⁹ on each axis of the volume, so that no sum overflows.
    glm::ivec3 normal{0};
    std::int32_t offset = 0;
    bool operator==(const VoxelBound&) const = default;
};

/// Give a label to voxels. Each chosen voxel at which the plane holds 0, the label or a label in
/// `overwritable` receives the label, and a seed word there that has another label, of a member or
/// a pending seed, becomes unvisited. So no growth continues from the voxels that this took, and
/// none counts them as its own.
struct LabelTarget {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    std::bitset<256> overwritable{};
};

/// Chosen are the voxels whose coverage in the layer is ≥ 128, whether or not the layer is muted.
struct LabelCarved {
    LabelTarget target{};
    std::uint8_t layer = 0;
    std::optional<EditableVoxels> editable{}; ///< none: any
};

/// Chosen are the voxels that are visible from anywhere: coverage < 128 in all layers that are not
/// muted, lowCode ≤ code ≤ highCode, and inside every bound.
struct LabelSeen {
    LabelTarget target{};
    int lowCode = 0;
    int highCode = 65535;
    std::vector<VoxelBound> bounds{};
    std::optional<EditableVoxels> editable{}; ///< none: any
};

/// Give labels to listed voxels. Each follows the rule of LabelTarget with the label requested for
/// it; where 0 is requested, nothing happens. Where `frees` is requested, which may be any number
/// that is not given as a label, a voxel at which the plane holds a label in `overwritable` becomes
/// 0, and a seed word there that has this label becomes unvisited (as when PaintLabel erases).
struct LabelListed {
    struct Brick {
        std::uint32_t brick = 0;
        std::vector<std::uint8_t> labels; ///< of its 4096 voxels
    };
    std::uint8_t plane = 0;
    std::bitset<256> overwritable{};
    std::vector<Brick> bricks{}; ///< ascending, each once
    std::uint8_t frees = 0; ///< 0: no voxel is freed
    std::optional<EditableVoxels> editable{}; ///< none: any; neither given nor freed elsewhere
};

/// LabelListed in several planes, one after another: what `editable` says of other planes is
/// evaluated when the edit comes to a plane.
struct LabelPlanes {
    std::vector<LabelListed> planes{}; ///< ascending by plane, each once; at least one
};

/// Give a label to listed voxels, and remove it from others. A voxel that is to receive it follows
/// the rule of LabelTarget. A voxel that is to lose it becomes 0 if the plane holds the label
/// there, and a seed word there that has the label becomes unvisited (as when PaintLabel erases).
struct RelabelListed {
    static constexpr std::uint8_t give = 1;
    static constexpr std::uint8_t take = 2;
    struct Brick {
        std::uint32_t brick = 0;
        std::vector<std::uint8_t> asked; ///< of its 4096 voxels: give, take or 0 (nothing)
    };
    LabelTarget target{};
    std::vector<Brick> bricks{}; ///< ascending, each once
    std::optional<EditableVoxels> editable{}; ///< none: any
};

[[nodiscard]] constexpr std::array<std::uint8_t, 256> everyLabelItself()
{
    std::array<std::uint8_t, 256> labels{};
    for (std::size_t label = 0; label < labels.size(); ++label)
        labels[label] = std::uint8_t(label);
    return labels;
}

/// Replace all labels of a plane at once: a voxel that holds v receives becomes[v]. Its seed word
/// changes like this:
/// - if becomes[v] is v, it stays;
/// - if becomes[v] is another segment's label, a word that has yet another label becomes unvisited,
///   as by LabelTarget;
/// - if becomes[v] is 0, a word that has v becomes unvisited, as when PaintLabel erases.
///
/// Voxels that are carved or hidden are treated like all others.
struct MapLabels {
    std::uint8_t plane = 0;
    std::array<std::uint8_t, 256> becomes = everyLabelItself();
    std::optional<EditableVoxels> editable{}; ///< none: any
};

/// MapLabels in several planes, one after another in this order: what `editable` says of other
/// planes is evaluated when the edit comes to a plane.
struct MapPlanes {
    std::vector<MapLabels> planes{}; ///< each plane once; at least one
};

/// Coverage of the layer = 255 wherever the plane holds the label; or, with `outside`, wherever in
/// the volume it holds neither the label nor one of protectedLabels.
struct CoverLabel {
    std::uint8_t layer = 0;
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    bool outside = false;
    std::bitset<256> protectedLabels{}; ///< with `outside` alone
};

/// Empty a layer. With `into`, another layer receives it first: coverage = max(coverage, that of
/// the layer).
struct FoldLayer {
    std::uint8_t layer = 0;
    std::optional<std::uint8_t> into{};
};

[[nodiscard]] Result<void> checkSound(const LabelCarved& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const LabelSeen& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const LabelListed& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const LabelPlanes& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const RelabelListed& edit, const BrickGrid& grid);
/// Every table is sound; only the bounds are checked.
[[nodiscard]] inline Result<void> checkSound(const MapLabels& edit, const BrickGrid&)
{
    return checkSound(edit.editable);
}
[[nodiscard]] Result<void> checkSound(const MapPlanes& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const CoverLabel& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const FoldLayer& edit, const BrickGrid& grid);

struct LabelOutlined; ///< LabelOutlined.h

/// Commands that give or take labels in one go.
using LabelWrites =
    TypeList<LabelCarved, LabelSeen, LabelListed, LabelPlanes, RelabelListed, LabelOutlined>;

} // namespace core

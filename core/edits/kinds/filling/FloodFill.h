// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/SliceAxis.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/growth/SeedStatistics.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <optional>

namespace core {

struct BrickBits;
struct CapsuleFrame;
struct RelabelListed;
struct VolumeGeometry;
struct VoxelEncoding;

/// Flood fill from a place, within a slice or in all directions. It gives a segment the connected
/// region of voxels whose values are close to the one at the place, or, with `erase`, removes the
/// connected region of the segment's voxels there. When filling, values alone decide how far it
/// reaches: voxels of other segments do not stop it, but they keep their labels unless they may be
/// overwritten. The result is computed each time the edit is carried out
/// (core/islands/BrickFlood.h).
struct FloodFill {
    int segment = 0; ///< label
    /// It begins with the voxel that contains this place; in an oblique slice, with the voxel of
    /// the slice that lies under it.
    glm::dvec3 placeLps{0.0};
    /// Only within the slice across this axis; none: in all directions.
    std::optional<SliceAxis> within{};
    /// Only within the slice through the place that is perpendicular to this direction, and oblique
    /// to the grid. It is one voxel thick, like a disc of the brush (core/sculpt/CapsuleSweep.h,
    /// rules 1 and 2). Voxels of it are neighbours as for a brush that follows edges
    /// (core/sculpt/EdgeRegion.h, rule 3), and with `corners` also if they touch at all. Not given
    /// with `within`.
    std::optional<glm::dvec3> normalLps{};
    bool corners = false; ///< voxels are also neighbours if they share only an edge or a corner
    bool erase = false;
    /// How far values may differ from the one at the place, modality units; not used to erase.
    double tolerance = 0.0;
    bool overwriteUnlocked = false;
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const FloodFill& edit, const Document& document);
Result<bool> apply(const FloodFill& edit, Document& document);
[[nodiscard]] EditEffects effects(const FloodFill& edit);
[[nodiscard]] RowTitle rowTitle(const FloodFill& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const FloodFill& edit, const DependencyFacts& row);

/// Whether it stays within a slice.
[[nodiscard]] inline bool isInSlice(const FloodFill& edit)
{
    return edit.within || edit.normalLps;
}
/// The oblique slice of an edit with `normalLps`, in an engine's integers. The first voxel belongs
/// to it even if rounding puts it on the other side of its border. None: the edit has none, or no
/// direction (check()).
[[nodiscard]] std::optional<CapsuleFrame> obliqueSlice(
    const FloodFill& edit, const VolumeGeometry& geometry);

/// The voxel in which it begins. Errors: InvalidField (outside the volume, or no direction).
[[nodiscard]] Result<glm::ivec3> firstVoxel(const FloodFill& edit, const VolumeGeometry& geometry);
/// The codes within the tolerance.
/// @param code that of the first voxel
[[nodiscard]] CodeInterval floodInterval(
    const FloodFill& edit, const VoxelEncoding& encoding, int code);
/// The command that writes the region; without bricks if there is nothing to do.
/// @param found the voxels of the region, by brick
/// Errors: UnknownSegment, SegmentLocked, NoIslandThere (to erase: the segment has no voxel at the
/// place).
[[nodiscard]] Result<RelabelListed> relabelListed(const FloodFill& edit, const Document& document,
    const std::map<std::uint32_t, BrickBits>& found);

} // namespace core

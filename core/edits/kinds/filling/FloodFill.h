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
struct RelabelListed;
struct VolumeGeometry;
struct VoxelEncoding;

/// Give a segment what hangs together with a place and has about its value, or take away what hangs
/// together of the segment there; within a slice or in all directions. Values alone decide how far
/// it reaches: voxels of other segments are no obstacle, though they stay theirs. It is worked out
/// anew whenever it is carried out (core/islands/BrickFlood.h).
struct FloodFill {
    int segment = 0; ///< label
    glm::dvec3 placeLps{0.0}; ///< it begins with the nearest voxel
    /// Only in the slice across this axis; none: in all directions.
    std::optional<SliceAxis> within{};
    bool corners = false; ///< voxels also hang together at an edge or a corner
    bool erase = false;
    /// How far values may differ from the one at the place, modality units; erasing asks for none.
    double tolerance = 0.0;
    bool overwriteUnlocked = false;
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const FloodFill& edit, const Document& document);
Result<bool> apply(const FloodFill& edit, Document& document);
[[nodiscard]] EditEffects effects(const FloodFill& edit);
[[nodiscard]] RowTitle rowTitle(const FloodFill& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const FloodFill& edit, const DependencyFacts& row);

/// The voxel with which it begins. Errors: InvalidField (outside the volume).
[[nodiscard]] Result<glm::ivec3> firstVoxel(const FloodFill& edit, const VolumeGeometry& geometry);
/// The codes that belong to it. @param code that of the first voxel
[[nodiscard]] CodeInterval floodInterval(
    const FloodFill& edit, const VoxelEncoding& encoding, int code);
/// The edit for an engine; no bricks: there is nothing to be done. Errors: UnknownSegment,
/// SegmentLocked, NoIslandThere (there is nothing of the segment to be erased).
/// @param found by brick
[[nodiscard]] Result<RelabelListed> relabelListed(const FloodFill& edit, const Document& document,
    const std::map<std::uint32_t, BrickBits>& found);

} // namespace core

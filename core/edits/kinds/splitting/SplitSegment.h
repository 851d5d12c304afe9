// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/splitting/SplitParts.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace core {

struct RelabelListed;

/// Split a segment by a plane: its voxels whose centres lie beyond the plane, on the side to which
/// the normal points, become a new segment. If the segment lies on one side entirely, nothing
/// happens. Like CleanSegment it stores no voxels: the result is computed from the labels each time
/// it is carried out. As a preview it writes the label of the new segment, which is the document's
/// once it is committed.
struct SplitSegment {
    int segment = 0; ///< label
    glm::dvec3 placeLps{0.0}; ///< a point of the plane
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< of any length
    SplitPart into{}; ///< the new segment
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const SplitSegment& edit, const Document& document);
Result<bool> apply(const SplitSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const SplitSegment& edit);
[[nodiscard]] OpenManner openManner(const SplitSegment& edit);
[[nodiscard]] RowTitle rowTitle(const SplitSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SplitSegment& edit, const DependencyFacts& row);

/// Which voxels of its segment the edit would give to the new one if all of them might change: its
/// editable range is ignored.
/// @param voxels all those of the segment
/// Any thread. Errors: InvalidField (a normal of length 0), Cancelled.
[[nodiscard]] Result<SplitSides> sidesOf(const SplitSegment& edit, const Document& document,
    const VoxelRuns& voxels, const Progress& progress);

/// The command that carries out the edit; without bricks if there is nothing to do.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread. Errors: UnknownSegment, SegmentLocked, InvalidField (a normal of length 0, no room
/// for another segment), Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const SplitSegment& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core

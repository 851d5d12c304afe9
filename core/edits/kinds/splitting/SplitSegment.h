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

/// Split a segment by a plane: its voxels whose centres lie beyond the plane, where the normal
/// points to, become a new segment. Where all of it lies on one side, nothing happens. Like
/// CleanSegment it is worked out anew from the labels whenever it is carried out.
struct SplitSegment {
    int segment = 0; ///< label
    glm::dvec3 placeLps{0.0}; ///< in the plane
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< of any length
    SplitPart into{}; ///< the new segment
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const SplitSegment& edit, const Document& document);
Result<bool> apply(const SplitSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const SplitSegment& edit);
[[nodiscard]] RowTitle rowTitle(const SplitSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SplitSegment& edit, const DependencyFacts& row);

/// The edit for an engine; no bricks: there is nothing to be done.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Any thread. Errors: UnknownSegment, SegmentLocked, InvalidField (a normal of no length, no room
/// for another segment), Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const SplitSegment& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core

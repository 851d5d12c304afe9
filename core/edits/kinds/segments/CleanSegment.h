// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/islands/SegmentIslands.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>

namespace core {

struct RelabelListed;
struct VolumeGeometry;

/// Fill holes of a segment, remove islands from it, or give one to another segment
/// (core/islands/SegmentIslands.h). What it does is worked out anew from the labels whenever it is
/// carried out.
struct CleanSegment {
    int segment = 0; ///< label
    IslandRule rule = IslandRule::FillHoles;
    /// For FillHoles the largest hole that is filled; none: all. For RemoveSmall the smallest
    /// island that stays, and required.
    std::optional<double> mm3{};
    /// A place in the island that KeepClicked, RemoveClicked and GiveClicked are about; required
    /// for them, and for no other rule.
    std::optional<glm::dvec3> islandLps{};
    std::optional<int> to{}; ///< label that receives the island; required for GiveClicked alone
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const CleanSegment& edit, const Document& document);
Result<bool> apply(const CleanSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const CleanSegment& edit);
[[nodiscard]] RowTitle rowTitle(const CleanSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const CleanSegment& edit, const DependencyFacts& row);

/// The edit for an engine; no bricks: there is nothing to be done. Holes are filled where nothing
/// is: voxels of other segments stay theirs.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Any thread. Errors: UnknownSegment, SegmentLocked, InvalidField (the place lies outside the
/// volume), NoIslandThere, Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const CleanSegment& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core

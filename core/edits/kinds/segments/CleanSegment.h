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

/// Fill holes of a segment, remove islands from it, or give an island to another segment
/// (core/islands/SegmentIslands.h). The edit stores no voxels: which ones change is computed from
/// the labels each time it is carried out.
struct CleanSegment {
    int segment = 0; ///< label
    IslandRule rule = IslandRule::FillHoles;
    /// For FillHoles: the largest hole that is filled; none: all holes. For RemoveSmall: the
    /// smallest island that stays; required.
    std::optional<double> mm3{};
    /// A place in the island that KeepClicked, RemoveClicked or GiveClicked is about; required for
    /// these, and refused for the other rules.
    std::optional<glm::dvec3> islandLps{};
    /// Label of the segment that receives the island; required for GiveClicked, refused otherwise.
    std::optional<int> to{};
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const CleanSegment& edit, const Document& document);
Result<bool> apply(const CleanSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const CleanSegment& edit);
[[nodiscard]] RowTitle rowTitle(const CleanSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const CleanSegment& edit, const DependencyFacts& row);
[[nodiscard]] OpenManner openManner(const CleanSegment& edit);

/// The command that carries out the edit; without bricks if there is nothing to do. Holes are
/// filled only where no segment is.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread outside a parallelFor(). Errors: UnknownSegment, SegmentLocked, InvalidField (a field
/// that the rule needs is missing or one that it does not use is given; the place lies outside the
/// volume; the segments lie in different planes), NoIslandThere, Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const CleanSegment& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core

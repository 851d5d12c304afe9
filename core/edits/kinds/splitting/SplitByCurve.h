// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/document/OrthographicView.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/splitting/SplitParts.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

struct RelabelListed;

/// Split a segment by a curve on the 3D view, along the view direction: its voxels on one side of
/// the curve become a new segment. What lies under a curve is the same as for the scissors that
/// erase (SegmentScissors.h). If one side would have all of the segment, nothing happens. Like
/// SplitSegment it stores no voxels: the result is computed from the labels each time it is carried
/// out.
struct SplitByCurve {
    enum class Side : std::uint8_t {
        Inside, ///< of an open curve: on its left, seen along it
        Outside,
        Smaller, ///< where fewer voxels of the segment lie; inside, if there are as many
        Larger, ///< the other one
    };
    int segment = 0; ///< label
    OrthographicView view{};
    /// Whether the curve is a line whose ends go on straight beyond all of the segment
    /// (LineAcross.h). Otherwise it is closed from the last point to the first.
    bool open = false;
    /// In the view plane, mm right and up from the target.
    std::vector<glm::dvec2> curveMm{};
    Side side = Side::Inside; ///< where the new segment lies
    /// Only up to this depth behind the first voxel of the segment that each line of sight meets.
    /// None: through everything. Refused with any side but Inside.
    std::optional<double> depthMm{};
    SplitPart into{}; ///< the new segment
    ClipHalfSpaces hidden{}; ///< hidden voxels stay, and count on no side
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const SplitByCurve& edit, const Document& document);
Result<bool> apply(const SplitByCurve& edit, Document& document);
[[nodiscard]] EditEffects effects(const SplitByCurve& edit);
[[nodiscard]] RowTitle rowTitle(const SplitByCurve& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SplitByCurve& edit, const DependencyFacts& row);

/// Which voxels of its segment the edit would give to the new one if all of them might change: its
/// editable range is ignored.
/// @param voxels all those of the segment Any thread. Errors: those of check() (but locks are
/// ignored), Cancelled.
[[nodiscard]] Result<SplitSides> sidesOf(const SplitByCurve& edit, const Document& document,
    const VoxelRuns& voxels, const Progress& progress);

/// The command that carries out the edit; without bricks if there is nothing to do.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread. Errors: UnknownSegment, SegmentLocked, InvalidField (a curve that is too small or
/// has no direction at its ends, a view without direction, a depth with another side than Inside,
/// no room for another segment), Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const SplitByCurve& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core

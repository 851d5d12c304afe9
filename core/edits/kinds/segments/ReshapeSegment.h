// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/morphology/SegmentShape.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

struct LabelListed;
struct LabelPlane;
struct LabelPlanes;
struct RelabelListed;

/// Margins of Grow and Shrink that differ towards some sides of the patient. On sides that are left
/// out the margin is ReshapeSegment::mm.
struct SideMargins {
    std::optional<double> rightMm{};
    std::optional<double> leftMm{};
    std::optional<double> anteriorMm{};
    std::optional<double> posteriorMm{};
    std::optional<double> inferiorMm{};
    std::optional<double> superiorMm{};

    [[nodiscard]] std::array<std::optional<double>, 6> all() const
    {
        return {rightMm, leftMm, anteriorMm, posteriorMm, inferiorMm, superiorMm};
    }
};

/// Grow or shrink a segment by a margin, hollow it out, open, close, wrap or smooth it, with a ball
/// of millimetres (core/morphology/SegmentShape.h) or a Gaussian (core/morphology/GaussianShape.h).
/// Like CleanSegment it stores no voxels: the result is computed from the labels each time it is
/// carried out.
struct ReshapeSegment {
    int segment = 0; ///< label
    ShapeOperation operation = ShapeOperation::Grow;
    /// The margin, the thickness of the shell, the radius of the ball, or the standard deviation of
    /// the Gaussian.
    double mm = 0.0;
    std::optional<ShellPlace> shell{}; ///< only for Hollow; none: inside
    /// Only for Gaussian: labels of other segments, ascending, that are smoothed together with it
    /// (jointGaussianChange()): in each label plane those that lie there, beside what is free in
    /// it.
    std::optional<std::vector<int>> with{};
    /// Only for Median: in a study of a single slice the ball is a disc (flatBallOf()). Older
    /// sessions use the whole ball.
    std::optional<bool> flat{};
    SideMargins sides{}; ///< only for Grow and Shrink (core/morphology/SidedMargin.h)
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const ReshapeSegment& edit, const Document& document);
Result<bool> apply(const ReshapeSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const ReshapeSegment& edit);
[[nodiscard]] RowTitle rowTitle(const ReshapeSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ReshapeSegment& edit, const DependencyFacts& row);
[[nodiscard]] OpenManner openManner(const ReshapeSegment& edit);

/// The command that carries out an edit without `with`; without bricks if there is nothing to do.
/// It takes only voxels that no segment has.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread outside a parallelFor(). Errors: UnknownSegment, SegmentLocked, InvalidField (the
/// ball is too small or too large), OutOfMemory, Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const ReshapeSegment& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

/// The same for an edit with `with`. The segments that are smoothed together take voxels from each
/// other.
/// @pre all of them lie in one plane
[[nodiscard]] Result<LabelListed> labelListed(const ReshapeSegment& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress);

/// The same for segments in any planes.
/// @param planes those in which they lie, ascending, each once
[[nodiscard]] Result<LabelPlanes> labelPlanes(const ReshapeSegment& edit, const Document& document,
    std::span<const LabelPlane> planes, const Progress& progress);

} // namespace core

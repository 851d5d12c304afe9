// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

struct LabelScissors;

/// Give a segment the voxels that lie under a closed curve on the 3D view, along the view
/// direction, or remove them from it; with `outside`, all voxels that do not lie under it. The
/// curve and what counts as under it are the same as for the scissors that carve (ScissorsCut.h).
struct SegmentScissors {
    int segment = 0; ///< label
    OrthographicView view{};
    /// Closed from the last point to the first; in the view plane, mm right and up from the target.
    std::vector<glm::dvec2> polygonMm{};
    bool erase = false;
    bool outside = false;
    /// Only up to this depth behind the first voxel that each line of sight meets: while erasing,
    /// the first one of the segments that are erased, otherwise the first one whose value lies in
    /// the interval. None: through the whole volume. A depth is refused with `outside`.
    std::optional<double> depthMm{};
    /// Labels of further segments that are erased, too; all in the same label plane. Only with
    /// `erase`.
    std::optional<std::vector<int>> others{};
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    bool overwriteUnlocked = false;
    ClipHalfSpaces hidden{}; ///< hidden voxels do not change
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const SegmentScissors& edit, const Document& document);
Result<bool> apply(const SegmentScissors& edit, Document& document);
[[nodiscard]] EditEffects effects(const SegmentScissors& edit);
[[nodiscard]] RowTitle rowTitle(const SegmentScissors& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const SegmentScissors& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const SegmentScissors& edit, const Document& document);

/// Converts the edit to an engine's integers. The cost is that of the curve. Errors:
/// UnknownSegment, SegmentLocked, InvalidField (bounds in the wrong order; `others` without
/// `erase`, or on another plane; a depth with `outside`; a view without direction; a curve that is
/// too small).
[[nodiscard]] Result<LabelScissors> labelScissors(
    const SegmentScissors& edit, const Document& document);

} // namespace core

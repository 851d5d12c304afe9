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

/// Give a segment what lies under a closed curve on the 3D view, along the view direction, or take
/// it away from there; or the same with all that does not lie under it. The scissors that carve
/// have the same curve (ScissorsCut.h) and the same places under it.
struct SegmentScissors {
    int segment = 0; ///< label
    OrthographicView view{};
    /// closed from the last point to the first; in the view plane, from the target
    std::vector<glm::dvec2> polygonMm{};
    bool erase = false;
    bool outside = false;
    /// Only so far behind what each line of sight meets first: of the segments, where it erases,
    /// else of the values. None: through everything, and so outside always is.
    std::optional<double> depthMm{};
    /// Further segments that it erases, by label, of the same plane.
    std::optional<std::vector<int>> others{};
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    bool overwriteUnlocked = false;
    ClipHalfSpaces hidden{}; ///< stays as it is
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const SegmentScissors& edit, const Document& document);
Result<bool> apply(const SegmentScissors& edit, Document& document);
[[nodiscard]] EditEffects effects(const SegmentScissors& edit);
[[nodiscard]] RowTitle rowTitle(const SegmentScissors& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const SegmentScissors& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const SegmentScissors& edit, const Document& document);

/// The cost is that of the curve. Errors: UnknownSegment, SegmentLocked, InvalidField (bounds in
/// the wrong order; others where nothing is erased, or on another plane; a depth outside of the
/// curve; a view without direction; a curve that is too small).
[[nodiscard]] Result<LabelScissors> labelScissors(
    const SegmentScissors& edit, const Document& document);

} // namespace core

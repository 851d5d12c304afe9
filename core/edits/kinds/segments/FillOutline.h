// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

struct LabelOutlined;

/// Give a segment what lies inside a closed outline in one slice, or take it away there. Any plane
/// through the volume is a slice; it is one voxel thick, as a disc of the brush is.
struct FillOutline {
    int segment = 0; ///< label
    glm::dvec3 originLps{0.0}; ///< a point of the slice
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< a direction in the slice
    /// Another one; what it has of `rightLps` does not count.
    glm::dvec3 upLps{0.0, 1.0, 0.0};
    /// Closed from the last corner to the first; right and up from the origin. It may cross itself:
    /// inside is whatever it winds around, and so are places on the outline.
    std::vector<glm::dvec2> polygonMm{};
    bool erase = false;
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    bool overwriteUnlocked = false;
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const FillOutline& edit, const Document& document);
Result<bool> apply(const FillOutline& edit, Document& document);
[[nodiscard]] EditEffects effects(const FillOutline& edit);
[[nodiscard]] RowTitle rowTitle(const FillOutline& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const FillOutline& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const FillOutline& edit, const Document& document);

/// The cost is that of the corners. Errors: UnknownSegment, SegmentLocked, InvalidField (bounds in
/// the wrong order; directions that span no plane; a plane that misses the volume; fewer than three
/// corners, too many, or one too far away).
[[nodiscard]] Result<LabelOutlined> labelOutlined(
    const FillOutline& edit, const Document& document);

} // namespace core

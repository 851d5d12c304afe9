// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

struct LabelOutlined;

/// Give a segment the voxels inside a closed outline in one slice, or remove them from it. The
/// slice may lie along any plane through the volume; it is one voxel thick, like a disc of the
/// brush.
struct FillOutline {
    int segment = 0; ///< label
    glm::dvec3 originLps{0.0}; ///< a point of the slice
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< a direction in the slice
    /// A second direction in the slice; only its part perpendicular to `rightLps` counts.
    glm::dvec3 upLps{0.0, 1.0, 0.0};
    /// Closed from the last corner to the first; mm right and up from the origin. The outline may
    /// cross itself: inside is every place that it winds around, and every place on it.
    std::vector<glm::dvec2> polygonMm{};
    bool erase = false;
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    bool overwriteUnlocked = false;
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const FillOutline& edit, const Document& document);
Result<bool> apply(const FillOutline& edit, Document& document);
[[nodiscard]] EditEffects effects(const FillOutline& edit);
[[nodiscard]] RowTitle rowTitle(const FillOutline& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const FillOutline& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const FillOutline& edit, const Document& document);

/// Converts the edit to an engine's integers. Cost ∝ the corners. Errors: UnknownSegment,
/// SegmentLocked, InvalidField (bounds in the wrong order; directions that span no plane; a plane
/// that misses the volume; fewer than three corners, too many, or one too far away).
[[nodiscard]] Result<LabelOutlined> labelOutlined(
    const FillOutline& edit, const Document& document);

} // namespace core

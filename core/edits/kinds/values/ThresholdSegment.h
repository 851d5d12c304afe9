// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/parts/GrowBox.h"

#include <cstdint>
#include <optional>

namespace core {

struct LabelThreshold;

/// Give a segment every voxel whose value lies in an interval, or remove these voxels from it. It
/// can stand open, so that a user sees the result before it becomes a step; any other action while
/// it is open takes it back.
struct ThresholdSegment {
    enum class Mode : std::uint8_t {
        Replace, ///< the segment consists of exactly these voxels afterwards
        Add,
        Subtract,
    };
    int segment = 0; ///< label
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    Mode mode = Mode::Replace;
    /// Whether voxels that are carved away by layers that are not muted stay as they are; otherwise
    /// they are treated like all others.
    bool onlyVisible = false;
    std::optional<GrowBox> box{}; ///< voxels outside stay as they are; none: the whole volume
    bool overwriteUnlocked = false;
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
    bool operator==(const ThresholdSegment&) const = default;
};

[[nodiscard]] Result<void> check(const ThresholdSegment& edit, const Document& document);
Result<bool> apply(const ThresholdSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const ThresholdSegment& edit);
[[nodiscard]] RowTitle rowTitle(const ThresholdSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const ThresholdSegment& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const ThresholdSegment& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(ThresholdSegment& edit);

/// Converts the edit to an engine's integers. Errors: UnknownSegment, SegmentLocked, InvalidField
/// (lower > upper, a box outside the volume).
[[nodiscard]] Result<LabelThreshold> labelThreshold(
    const ThresholdSegment& edit, const Document& document);

} // namespace core

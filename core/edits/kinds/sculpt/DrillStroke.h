// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"
#include "core/edits/kinds/sculpt/ToolMask.h"
#include "core/sculpt/DrillCut.h"

#include <vector>

namespace core {

/// Drill into the volume along the view direction with a mask that the pen moves (seed A §4.1,
/// 4.2).
struct DrillStroke {
    int layer = 1;
    OrthographicView view{};
    ToolMask mask{};
    DrillMode mode = DrillMode::Limit;
    double depthMm = 8.0; ///< at full pressure; in mode Rate per second
    double floorMm = 30.0; ///< mode Rate: the greatest depth
    int pressureExponent = 2;
    double surfaceThreshold = 0.0; ///< modality units; values from this one on are visible
    bool throughGaps = false;
    /// Parts of the surface that are farther back than the depth by this much are left alone, since
    /// they are seen through a gap; 0: all are cut.
    double guardMm = 0.0;
    bool restore = false; ///< refill what was carved, from the surface towards the viewer
    /// Resample by time, so that the device's report rate does not matter. Mode Rate always does.
    bool byTime = true;
    std::vector<PenSample> samples{};
    ClipHalfSpaces hidden{};
    ProtectedSegments protectedSegments{};
};

[[nodiscard]] Result<void> check(const DrillStroke& edit, const Document& document);
Result<bool> apply(const DrillStroke& edit, Document& document);
[[nodiscard]] EditEffects effects(const DrillStroke& edit);
[[nodiscard]] RowTitle rowTitle(const DrillStroke& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const DrillStroke& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const DrillStroke& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(DrillStroke& edit);

/// A stroke without its path (DrillPathSampler.h); its samples are not used. Errors: InvalidField
/// (also for a mask that is too small).
[[nodiscard]] Result<DrillCut> drillCut(const DrillStroke& stroke, const Document& document);

} // namespace core

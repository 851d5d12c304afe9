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

struct LaserCut;

/// Like a drill, but the mask is perpendicular to the surface's normal and cuts along it (seed A
/// §4.3).
struct LaserStroke {
    int layer = 1;
    OrthographicView view{};
    ToolMask mask{};
    DrillMode mode = DrillMode::Limit;
    double depthMm = 15.0; ///< at full pressure; in mode Rate per second
    double floorMm = 30.0; ///< mode Rate: the greatest depth
    int pressureExponent = 2;
    double surfaceThreshold = 0.0; ///< modality units; values from this one on are visible
    bool throughGaps = false;
    bool restore = false;
    bool byTime = true; ///< as in DrillStroke
    std::vector<PenSample> samples{};
    ClipHalfSpaces hidden{};
    ProtectedSegments protectedSegments{};
};

[[nodiscard]] Result<void> check(const LaserStroke& edit, const Document& document);
Result<bool> apply(const LaserStroke& edit, Document& document);
[[nodiscard]] EditEffects effects(const LaserStroke& edit);
[[nodiscard]] RowTitle rowTitle(const LaserStroke& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const LaserStroke& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const LaserStroke& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(LaserStroke& edit);

/// A stroke without its path (DrillPathSampler.h). Errors: InvalidField (also for a mask that is
/// too small).
[[nodiscard]] Result<LaserCut> laserCut(const LaserStroke& stroke, const Document& document);
/// The greatest distance from the path at which a laser can read or cut, in any direction.
[[nodiscard]] double laserReachMm(const LaserCut& cut);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/edits/kinds/parts/SparedSegments.h"
#include "core/edits/kinds/sculpt/MaskShape.h"
#include "core/edits/kinds/sculpt/PenSample.h"
#include "core/sculpt/DrillCut.h"

#include <vector>

namespace core {

/// As a drill, but the mask stands across the surface and goes in along its normal (seed A §4.3).
struct LaserStroke {
    int layer = 1;
    OrthographicView view{};
    MaskShape mask{};
    DrillMode mode = DrillMode::Limit;
    double depthMm = 15.0; ///< at full pressure; in mode Rate a second
    double floorMm = 30.0; ///< mode Rate: no deeper
    int pressureExponent = 2;
    double surfaceThreshold = 0.0; ///< modality units: what is seen
    bool throughGaps = false;
    bool restore = false;
    bool byTime = true; ///< as DrillStroke's
    std::vector<PenSample> samples{};
    HiddenSides hidden{};
    SparedSegments spared{};
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/edits/kinds/parts/SparedSegments.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// Takes a shell of even thickness off the part of the surface that a closed curve surrounds.
struct PeelCut {
    int layer = 1;
    OrthographicView view{};
    std::vector<glm::dvec2> polygonMm{}; ///< closed by itself; in the view plane, from the target
    double depthMm = 4.0;
    double surfaceThreshold = 0.0; ///< modality units: what is seen
    bool throughGaps = false;
    /// Where the surface jumps by more than this from one element to the next it is another
    /// surface, and only the largest is peeled; 0: all of them.
    double jumpMm = 4.0;
    bool restore = false;
    HiddenSides hidden{};
    SparedSegments spared{};
};

} // namespace core

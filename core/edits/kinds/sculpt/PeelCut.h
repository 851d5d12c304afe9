// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/edits/kinds/parts/SparedSegments.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

struct MaskPeel;
struct PeelDepth;

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

[[nodiscard]] Result<void> check(const PeelCut& edit, const Document& document);
Result<bool> apply(const PeelCut& edit, Document& document);
[[nodiscard]] EditEffects effects(const PeelCut& edit);
[[nodiscard]] RowTitle rowTitle(const PeelCut& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const PeelCut& edit, const ReachFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const PeelCut& edit, const Document& document);

/// A peel without its depth, and its depth. Errors: InvalidField (also a curve that is too small).
[[nodiscard]] Result<MaskPeel> maskPeel(const PeelCut& peel, const Document& document);
[[nodiscard]] PeelDepth peelDepth(const PeelCut& peel);

} // namespace core

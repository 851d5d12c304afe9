// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

struct PeelDepth;
struct ShellPeel;

/// Remove a shell of even thickness from the part of the surface inside a closed curve (seed A
/// §4.4).
struct PeelCut {
    int layer = 1;
    OrthographicView view{};
    /// closed from the last point to the first; in the view plane, from the target
    std::vector<glm::dvec2> polygonMm{};
    double depthMm = 4.0;
    double surfaceThreshold = 0.0; ///< modality units; values from this one on are visible
    bool throughGaps = false;
    /// A step of the surface between two elements by more than this separates surfaces, of which
    /// only the largest is peeled; 0: all are.
    double jumpMm = 4.0;
    bool restore = false;
    ClipHalfSpaces hidden{};
    ProtectedSegments protectedSegments{};
};

[[nodiscard]] Result<void> check(const PeelCut& edit, const Document& document);
Result<bool> apply(const PeelCut& edit, Document& document);
[[nodiscard]] EditEffects effects(const PeelCut& edit);
[[nodiscard]] RowTitle rowTitle(const PeelCut& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const PeelCut& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const PeelCut& edit, const Document& document);
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(PeelCut& edit);

/// A peel without its depth, and its depth. Errors: InvalidField (also for a curve that is too
/// small).
[[nodiscard]] Result<ShellPeel> shellPeel(const PeelCut& peel, const Document& document);
[[nodiscard]] PeelDepth peelDepth(const PeelCut& peel);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

struct OutlineCut;

/// Cut out what lies under a closed curve, along the view direction.
struct ScissorsCut {
    int layer = 1;
    OrthographicView view{};
    /// closed from the last point to the first; in the view plane, from the target
    std::vector<glm::dvec2> polygonMm{};
    std::optional<double> depthMm{}; ///< below the surface; none: through everything
    bool firstLayerOnly = false; ///< only to the first gap in the material
    double surfaceThreshold = 0.0; ///< modality units; values from this one on are visible
    bool restore = false;
    ClipHalfSpaces hidden{};
    ProtectedSegments protectedSegments{};
};

[[nodiscard]] Result<void> check(const ScissorsCut& edit, const Document& document);
Result<bool> apply(const ScissorsCut& edit, Document& document);
[[nodiscard]] EditEffects effects(const ScissorsCut& edit);
[[nodiscard]] RowTitle rowTitle(const ScissorsCut& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ScissorsCut& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const ScissorsCut& edit, const Document& document);

/// Errors: InvalidField (also for a curve that is too small).
[[nodiscard]] Result<OutlineCut> outlineCut(const ScissorsCut& cut, const Document& document);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/refine/mesh/SurfaceMark.h"

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Change all that is marked so at once, or one region of it.
struct ChangeMarks {
    enum class Way {
        Grow, ///< by the vertices beside it
        Shrink,
        Invert, ///< what is marked so turns yellow, all that is yellow is marked so
        Clear, ///< what is marked so turns yellow
        Accept, ///< what is marked red turns green: it is signed off
    };
    SurfaceMark mark = SurfaceMark::Red; ///< not yellow
    Way way = Way::Grow;
    /// Of Clear and Accept: only the region that hangs together and lies nearest to it; none: all.
    std::optional<glm::dvec3> nearLps{};
};

[[nodiscard]] Result<void> check(const ChangeMarks& edit, const Document& document);
Result<bool> apply(const ChangeMarks& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChangeMarks& edit);
[[nodiscard]] RowTitle rowTitle(const ChangeMarks& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const ChangeMarks& edit, const ReachFacts& row);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/refine/mesh/SurfaceMark.h"

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Change all marks of one colour, or one region of them, at once.
struct ChangeMarks {
    enum class Way {
        Grow, ///< also mark the neighbouring vertices
        Shrink,
        Invert, ///< exchange the mark with yellow
        Clear, ///< turn the mark into yellow
        Accept, ///< turn red into green: the region is approved
    };
    SurfaceMark mark = SurfaceMark::Red; ///< not yellow
    Way way = Way::Grow;
    /// For Clear and Accept: only the connected region nearest to this point; none: all.
    std::optional<glm::dvec3> nearLps{};
};

[[nodiscard]] Result<void> check(const ChangeMarks& edit, const Document& document);
Result<bool> apply(const ChangeMarks& edit, Document& document);
[[nodiscard]] EditEffects effects(const ChangeMarks& edit);
[[nodiscard]] RowTitle rowTitle(const ChangeMarks& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const ChangeMarks& edit, const DependencyFacts& row);

} // namespace core

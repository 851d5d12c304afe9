// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/surface/parts/SurfaceRules.h"

namespace core {

// Edits of the surface that is refined (seed B §4; core/refine). There is one surface at a time, of
// one segment, whose voxels are changed by WriteBack alone.

/// Lay a surface around the voxels of a segment, all of it yellow; it replaces the present one.
struct LaySurface {
    int segment = 0; ///< label
    /// Approximate number; 0: as many as are needed for the surface to enclose the segment's voxels
    /// (core/refine/fit/MeasuredFit.h).
    int vertices = 0;
    SurfaceRules rules{};
    /// If true, the present surface of the segment stays, except for the parts that pass through
    /// themselves or each other: these are replaced by new ones around the voxels that they enclose
    /// (core/refine/fit/CrossingParts.h), with the marks of the old ones. `vertices` and `rules`
    /// are ignored then.
    std::optional<bool> onlyCrossings{};
};

/// Whether this edit creates a new surface, which agrees with its segment afterwards.
[[nodiscard]] inline bool beginsSurface(const LaySurface& edit)
{
    return !edit.onlyCrossings.value_or(false);
}

[[nodiscard]] Result<void> check(const LaySurface& edit, const Document& document);
Result<bool> apply(const LaySurface& edit, Document& document);
[[nodiscard]] EditEffects effects(const LaySurface& edit);
[[nodiscard]] RowTitle rowTitle(const LaySurface& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const LaySurface& edit, const DependencyFacts& row);

} // namespace core

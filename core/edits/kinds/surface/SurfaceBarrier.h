// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Set barriers along the surface, or remove them: at every voxel whose centre lies outside and
/// that has a neighbour (26) whose centre lies inside. No growth passes such a shell, whatever its
/// connectivity, except where the rules of PaintBarrier leave a voxel open. The shell lies outside
/// so that a growth inside can fill everything that the surface encloses.
struct SurfaceBarrier {
    bool erase = false; ///< remove the barriers there
};

[[nodiscard]] Result<void> check(const SurfaceBarrier& edit, const Document& document);
Result<bool> apply(const SurfaceBarrier& edit, Document& document);
[[nodiscard]] EditEffects effects(const SurfaceBarrier& edit);
[[nodiscard]] RowTitle rowTitle(const SurfaceBarrier& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SurfaceBarrier& edit, const DependencyFacts& row);

} // namespace core

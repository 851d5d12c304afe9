// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/Edit.h"
#include "core/titles/RowTitle.h"

namespace core {

// Questions about the edit of a row.

/// What the row says to people: "Drill 6.2 mm, 214 bricks", "Grow 'Skull' 41 steps, +18 204
/// voxels", as a code with arguments.
[[nodiscard]] RowTitle titleOf(const Edit& edit, const RowFacts& row);

/// What its result depends on. Cost: of cuts and brushes, that of the conversion.
[[nodiscard]] EditDependencies dependenciesOf(const Edit& edit, const DependencyFacts& row);

} // namespace core

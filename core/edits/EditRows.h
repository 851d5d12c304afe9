// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/Edit.h"

namespace core {

// What is asked of the edit of a row.

/// The row's name for people: "Drill 6.2 mm, 214 bricks", "Grow 'Skull' 41 steps, +18 204 voxels".
[[nodiscard]] QString nameOf(const Edit& edit, const RowFacts& row);

/// What its result depends on. Cost: of cuts and brushes, that of the conversion.
[[nodiscard]] EditReach reachOf(const Edit& edit, const ReachFacts& row);

} // namespace core

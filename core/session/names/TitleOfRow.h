// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/EditStatistics.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/ChangeFacts.h"
#include "core/history/History.h"
#include "core/session/past/SketchedSeeds.h"
#include "core/titles/RowTitle.h"

#include <optional>

namespace core {

/// The name of a row for people: "Drill 6.2 mm, 214 bricks", "Grow 'Skull' 41 steps, +18 204
/// voxels".
/// @param facts of what it changed
/// @param document as it is before the edit
/// @param history as it is before the row; it provides the names of rows that the edit refers to
/// @param sketched for a SeedStroke; none: not determined
[[nodiscard]] RowTitle titleOfRow(const Edit& edit, const EditStatistics& statistics,
    const ChangeFacts& facts, const Document& document, const History& history,
    const std::optional<SketchedSeeds>& sketched);

} // namespace core

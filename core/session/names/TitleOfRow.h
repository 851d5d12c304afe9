// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/EngineCommands.h"
#include "core/history/History.h"
#include "core/session/past/SketchedSeeds.h"
#include "core/titles/RowTitle.h"

#include <optional>

namespace core {

/// What a row says to people: "Drill 6.2 mm, 214 bricks", "Grow 'Skull' 41 steps, +18 204 voxels",
/// as a code with arguments; its name is canonicalName() of that.
/// @param facts of what it changed
/// @param document as it is before the edit
/// @param history before the row; it names the rows that an edit speaks of
/// @param sketched of a SeedStroke; none: nobody asked
[[nodiscard]] RowTitle titleOfRow(const Edit& edit, const EditStatistics& statistics,
    const ChangeFacts& facts, const Document& document, const History& history,
    const std::optional<SketchedSeeds>& sketched);

} // namespace core

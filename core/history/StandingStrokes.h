// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/sculpt/SculptEdits.h"
#include "core/history/History.h"

#include <vector>

namespace core {

/// A cut of the history in its present form.
struct StandingStroke {
    RowId row = 0; ///< where it was made; its rays start on the surface as it was before that row
    SculptEdit form{}; ///< as the last ReviseStroke in effect made it
    bool removed = false; ///< by a ReviseStroke; it cuts nothing
    bool operator==(const StandingStroke& other) const;
};

/// The strokes that together make up the coverage after a row, in the order in which they were
/// drawn. Carving takes the maximum, restoring what it leaves. Strokes that RevertRows took back
/// are left out.
[[nodiscard]] std::vector<StandingStroke> standingStrokes(const History& history, RowId at);

/// All forms that a cut has had on the way to the position: as it was drawn, then each revision.
/// Empty if the row is no cut.
[[nodiscard]] std::vector<SculptEdit> formsOf(const History& history, RowId row);

/// Whether a stroke of the present state carves and can be removed from its layer without a trace:
/// since then, nothing was restored in the layer, and it was written only by strokes.
[[nodiscard]] bool canBeTaken(const History& history, RowId cut);

/// The last carving stroke of a layer, if it can be removed and the layer contains other coverage,
/// too; otherwise 0.
[[nodiscard]] RowId lastPartialCut(const History& history, int layer);

} // namespace core

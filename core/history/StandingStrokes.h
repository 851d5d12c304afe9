// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/sculpt/SculptEdits.h"
#include "core/history/History.h"

#include <vector>

namespace core {

/// A cut of the history as it counts now.
struct StandingStroke {
    RowId row = 0; ///< where it was made; its rays start on the surface as it was before that row
    SculptEdit form{}; ///< as the last ReviseStroke that stands made it
    bool removed = false; ///< by ReviseStroke: cuts nothing
    bool operator==(const StandingStroke& other) const;
};

/// The strokes whose cuts, laid over each other, are the coverage after a row; in the order in
/// which they were drawn: carving by the greater value, restoring by what it leaves. Those that
/// RevertRows took back are not among them.
[[nodiscard]] std::vector<StandingStroke> standingStrokes(const History& history, RowId at);

/// All forms that a cut has had on the way to the position: as it was drawn, and each revision.
/// None if the row is no cut.
[[nodiscard]] std::vector<SculptEdit> formsOf(const History& history, RowId row);

} // namespace core

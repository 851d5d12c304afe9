// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/history/History.h"

#include <cstdint>
#include <set>

namespace core {

/// The label planes in which an edit may move a growth to another generation: the plane of an edit
/// of growth, and for "undo only" the planes of the rows that it takes back. A row stores only one
/// generation, so edits of growths in several planes are not taken back at once (RevertOperation).
/// @pre the history holds the rows that the edit takes back
[[nodiscard]] std::set<std::uint8_t> movedGrowthPlanes(const Edit& edit, const History& history);

/// The plane whose generation a row of this edit stores (HistoryRow::growthGeneration).
[[nodiscard]] std::uint8_t recordedGrowthPlane(const Edit& edit, const History& history);

} // namespace core

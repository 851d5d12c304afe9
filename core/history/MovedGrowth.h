// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/history/History.h"

#include <cstdint>
#include <set>

namespace core {

/// The label planes whose growths have another generation after an edit: that of an edit of growth,
/// and for "undo only" those of the rows that it takes back. A row tells one generation, so edits
/// of growths in several planes are not taken back at once (RevertOperation).
/// @pre the history holds the rows that the edit takes back
[[nodiscard]] std::set<std::uint8_t> movedGrowthPlanes(const Edit& edit, const History& history);

/// The plane whose generation a row of the edit tells (HistoryRow::growthGeneration).
[[nodiscard]] std::uint8_t toldGrowthPlane(const Edit& edit, const History& history);

} // namespace core

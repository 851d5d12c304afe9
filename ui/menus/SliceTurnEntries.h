// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/SliceTurn.h"

#include <QString>

#include <vector>

namespace ui {

/// A way to flip or turn a slice on the screen, as the View menu and context menus offer it.
struct SliceTurnEntry {
    const char* id; ///< of the window's action
    QString text;
    SliceTurn (*after)(const SliceTurn& before);
};

/// All of them, in the order of a menu.
[[nodiscard]] const std::vector<SliceTurnEntry>& sliceTurnEntries();

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/ColourMap.h"

#include <QString>

#include <vector>

class QMenu;

namespace ui {

class Workspace;

/// A colour map, as the View menu and context menus offer it.
struct ColourMapEntry {
    const char* id; ///< of the window's action
    QString text;
    gpu::ColourMap map;
};

/// All of them, in the order of a menu.
[[nodiscard]] const std::vector<ColourMapEntry>& colourMapEntries();

/// Sets the colour map of slices and of the MIP.
void showColours(Workspace& workspace, gpu::ColourMap map);

/// Adds a submenu with all colour maps to a context menu. The present one is checked.
void addColourMaps(QMenu& menu, Workspace& workspace);

} // namespace ui

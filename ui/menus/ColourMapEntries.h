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
    const char* id; ///< of its action in the window
    QString text;
    gpu::ColourMap map;
};

/// All of them, in the order of a menu.
[[nodiscard]] const std::vector<ColourMapEntry>& colourMapEntries();

/// Shows slices and MIP in these colours.
void showColours(Workspace& workspace, gpu::ColourMap map);

/// Adds a submenu of them to a context menu; the one that is shown is marked.
void addColourMaps(QMenu& menu, Workspace& workspace);

} // namespace ui

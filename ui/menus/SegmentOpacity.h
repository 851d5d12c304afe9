// SPDX-License-Identifier: Apache-2.0
#pragma once

class QMenu;

namespace ui {

class Workspace;

/// Adds to a menu a slider for how opaque a segment is drawn in all views
/// (Workspace::segmentOpacities()). The views follow it while the menu is open; the wheel moves it.
/// @param label of the segment
void addSegmentOpacity(QMenu& menu, Workspace& workspace, int label);

} // namespace ui

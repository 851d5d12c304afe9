// SPDX-License-Identifier: Apache-2.0
#pragma once

class QMenu;

namespace ui {

class Workspace;

/// Adds a slider to a menu that sets the opacity of a segment in all views
/// (Workspace::segmentOpacities()). The views follow while the menu is open. The mouse wheel moves
/// the slider, too.
/// @param label of the segment
void addSegmentOpacity(QMenu& menu, Workspace& workspace, int label);

} // namespace ui

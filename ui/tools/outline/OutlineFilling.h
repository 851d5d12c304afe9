// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPolygonF>
#include <QString>

class QPainter;

namespace ui {

class SliceOutline;
class Workspace;

/// Fills an outline: the active segment gets the voxels inside it or, if @p erases, loses them,
/// within the limits of painting. If there is no segment, one is added, as a step of its own. The
/// workspace tells the user why the edit was refused.
/// @return whether the outline has become a step of the history
[[nodiscard]] bool fillOutline(Workspace& workspace, const SliceOutline& outline, bool erases);

/// A text on what fillOutline() would do at present: "fills Liver". Empty if no session is open.
[[nodiscard]] QString fillingText(const Workspace& workspace, bool erases);

/// Draws an outline and tints what would be filled. As in the edit, that is every place around
/// which the outline winds.
/// @param outline logical pixels of the view
/// @param isClosed whether its last side is drawn
void paintFilling(QPainter& painter, const Workspace& workspace, const QPolygonF& outline,
    bool erases, bool isClosed);

} // namespace ui

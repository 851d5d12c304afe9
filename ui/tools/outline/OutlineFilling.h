// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPolygonF>
#include <QString>

class QPainter;

namespace ui {

class SliceOutline;
class Workspace;

/// Gives the active segment what lies inside an outline, or takes it away, as the settings of paint
/// allow. If there is no segment, one is made, as a step of its own. What is refused is said.
/// @return whether the outline is a step of the history now
[[nodiscard]] bool fillOutline(Workspace& workspace, const SliceOutline& outline, bool erases);

/// "fills Liver": what that would do at present; empty if nothing is open.
[[nodiscard]] QString fillingText(const Workspace& workspace, bool erases);

/// Draws an outline in the pixels of a view with what would be filled, as the edit counts it:
/// whatever the outline winds around.
/// @param isClosed whether its last side is drawn
void paintFilling(QPainter& painter, const Workspace& workspace, const QPolygonF& outline,
    bool erases, bool isClosed);

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QToolButton>

#include <functional>

class QMenu;

namespace ui {

/// Reads and changes how one view draws segments.
struct LookOfView {
    std::function<Workspace::SegmentLook()> get;
    std::function<void(const Workspace::SegmentLook&)> set;
};

/// Adds entries to a menu that choose how segments are drawn in one view: fill and outline, the
/// opacity of the fill, and a return to the look of all views.
void addSegmentLook(QMenu& menu, Workspace& workspace, const LookOfView& look);

/// The small button in a corner of a slice that draws segments in a way of its own. It says how,
/// and its menu changes it (addSegmentLook()). It is hidden while the view draws segments as all
/// views do, so it covers nothing then.
class SegmentLookButton : public QToolButton {
    Q_OBJECT

public:
    SegmentLookButton(Workspace& workspace, LookOfView look, QWidget* view);

    /// Updates text, visibility and place: above the scale bar in the lower right corner.
    void showState();

private:
    Workspace& m_workspace;
    LookOfView m_look;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QToolButton>

#include <functional>

class QMenu;

namespace ui {

/// How one view draws segments, for those who show and change it.
struct LookOfView {
    std::function<Workspace::SegmentLook()> get;
    std::function<void(const Workspace::SegmentLook&)> set;
};

/// Adds to a menu how segments are drawn in this view: fill and outline, how opaque the fill is,
/// and as in all views again.
void addSegmentLook(QMenu& menu, Workspace& workspace, const LookOfView& look);

/// The small control in a corner of a slice that draws segments in its own way: says how, and has a
/// menu of the same. It is there only while the view does so, so that it covers nothing else.
class SegmentLookButton : public QToolButton {
    Q_OBJECT

public:
    SegmentLookButton(Workspace& workspace, LookOfView look, QWidget* view);

    /// Says what holds now, and stands over the scale bar in the lower right corner.
    void showState();

private:
    Workspace& m_workspace;
    LookOfView m_look;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <QFrame>

#include <optional>

class QButtonGroup;
class QSlider;
class QToolButton;

namespace ui {

class Workspace;

/// The small control in a corner of the 3D view: the volume, the volume and the segments in it, or
/// segments only. Beside it, while both are shown, stand the opacity of the volume and whether it
/// is cut away in front of segments instead.
///
/// It also steps the context back by itself: while a surface is refined the volume is not shown,
/// unless the user wants it; what was shown before comes back with the end of refining.
class ContextSwitch : public QFrame {
    Q_OBJECT

public:
    ContextSwitch(Workspace& workspace, QWidget* parent);

    /// What was shown before it stepped back; none if it did not, or the user has chosen since.
    [[nodiscard]] std::optional<gpu::Context> before() const;
    /// Makes before() what it was when the session was last open.
    void setBefore(std::optional<gpu::Context> before);

private:
    void choose(gpu::Context context);
    void showState();
    void followSurface();

    Workspace& m_workspace;
    QButtonGroup* m_choices;
    QWidget* m_ofBoth; ///< what matters while both are shown
    QSlider* m_opacity;
    QToolButton* m_cutAway;
    bool m_refining = false;
    bool m_steppedBack = false; ///< the user has not chosen otherwise since
    gpu::Context m_before = gpu::Context::Opaque; ///< when it stepped back
    gpu::Context m_both = gpu::Context::Translucent; ///< which way both are shown
};

} // namespace ui

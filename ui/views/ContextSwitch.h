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

/// The small control in a corner of the 3D view that chooses what is shown: the volume, the volume
/// and the segments in it, or segments only. While both are shown it also sets the opacity of the
/// volume and whether the volume is cut away in front of segments instead.
///
/// It also changes this by itself: when refining of a surface begins, it hides the volume; when
/// refining ends, it restores what was shown before, unless the user has chosen something else
/// meanwhile.
class ContextSwitch : public QFrame {
    Q_OBJECT

public:
    ContextSwitch(Workspace& workspace, QWidget* parent);

    /// What was shown before it hid the volume by itself; none if it did not, or if the user has
    /// chosen since.
    [[nodiscard]] std::optional<gpu::Context> before() const;
    /// Sets before() from a saved session.
    void setBefore(std::optional<gpu::Context> before);

private:
    void choose(gpu::Context context);
    void showState();
    void followSurface();

    Workspace& m_workspace;
    QButtonGroup* m_choices;
    QWidget* m_ofBoth; ///< controls that apply only while both are shown
    QSlider* m_opacity;
    QToolButton* m_cutAway;
    bool m_refining = false;
    bool m_steppedBack = false; ///< it has hidden the volume and the user has not chosen since
    gpu::Context m_before = gpu::Context::Opaque; ///< what was shown when it hid the volume
    /// How both are shown: translucent or cut away.
    gpu::Context m_both = gpu::Context::Translucent;
};

} // namespace ui

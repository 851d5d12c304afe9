// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QJsonObject>
#include <QObject>
#include <QTimer>

#include <vector>

namespace ui {

class Tool;
class ViewGrid;

/// The display state of a session: views, grey scale, look of the 3D view, crosshair, active
/// segment and layer, and settings of the tools. It is stored in the session's file and restored
/// when the session is opened again; it is never a step of undo. (Which segments are hidden is
/// stored by the session itself.)
///
/// Changes are written every few seconds and when the session closes. The format is described in
/// core/session/README.md; fields that are missing, unknown or invalid are ignored.
class DisplayState : public QObject {
    Q_OBJECT

public:
    /// Construct it after everything else that initialises itself when a session opens.
    DisplayState(
        Workspace& workspace, ViewGrid& views, std::vector<Tool*> tools, QObject* parent = nullptr);

    [[nodiscard]] QJsonObject composed() const;
    void apply(const QJsonObject& state);
    /// Applies only the part of such a state that says what is shown and how: crosshair, grey
    /// scale, what lies over slices, look of the 3D view, views; nothing of tools, segments, layers
    /// and pieces. Slices that it does not mention are laid upright along the patient's axes and
    /// fit their views.
    void applyLook(const QJsonObject& state);
    /// Passes the state to the session if it differs from what the session has.
    void keep();

private:
    void open();

    [[nodiscard]] QJsonObject composedViews() const;
    void applyShown(const QJsonObject& state);
    void applyViews(const QJsonObject& state);
    void applyTools(const QJsonObject& state);

    Workspace& m_workspace;
    ViewGrid& m_views;
    std::vector<Tool*> m_tools;
    QTimer m_timer;
    QJsonObject m_known; ///< composed() when it was last passed to the session
};

} // namespace ui

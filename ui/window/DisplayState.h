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

/// How the window looks at a session, kept in the session's file and put back when it is opened
/// again: views, grey scale, 3D look, crosshair, active segment and layer, the tools' settings.
/// Never a step of undo. (Which segments are hidden the session keeps itself.)
///
/// What changed is written every few seconds and when the session closes. The form is described in
/// core/session/README.md; fields that are missing, unknown or make no sense are passed over.
class DisplayState : public QObject {
    Q_OBJECT

public:
    /// Make it after everything that sets itself up when a session opens.
    DisplayState(
        Workspace& workspace, ViewGrid& views, std::vector<Tool*> tools, QObject* parent = nullptr);

    [[nodiscard]] QJsonObject composed() const;
    void apply(const QJsonObject& state);
    /// Hands it to the session if it is not what the session has.
    void keep();

private:
    void open();

    [[nodiscard]] QJsonObject composedViews() const;
    void applyViews(const QJsonObject& state);
    void applyTools(const QJsonObject& state);

    Workspace& m_workspace;
    ViewGrid& m_views;
    std::vector<Tool*> m_tools;
    QTimer m_timer;
    QJsonObject m_known; ///< composed() when the session was told last
};

} // namespace ui

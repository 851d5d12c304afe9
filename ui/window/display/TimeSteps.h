// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>
#include <QObject>
#include <QString>

namespace ui {

class DisplayState;
class StudyOpener;
class Workspace;

/// Leads from one point of a series in time to another. Each point is a study with a session of its
/// own and is opened as any other study is: what was drawn stays with its point, and comes back
/// with it. What is looked at is taken along: crosshair, grey scale, and places and zoom of the
/// views; to a point that was never looked at before, the look of the 3D view, too.
class TimeSteps : public QObject {
    Q_OBJECT

public:
    /// Construct it after @p display, which is to hear of a session first. All outlive this.
    TimeSteps(Workspace& workspace, StudyOpener& opener, DisplayState& display,
        QObject* parent = nullptr);

    /// Whether the open volume has a point that many later; negative: earlier.
    [[nodiscard]] bool hasPoint(int later) const;
    /// Opens it. Does nothing while something is being opened.
    void go(int later);
    /// @param time 0-based
    void openPoint(int time);

private:
    void takeAlong();

    Workspace& m_workspace;
    StudyOpener& m_opener;
    DisplayState& m_display;
    QString m_awaited; ///< key of the point that is being opened; empty: none
    QJsonObject m_look; ///< of the point before it
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/settings/growth/GrowSettings.h"

#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QTimer>

#include <cstddef>

namespace ui {

class DisplayState;
class StudyOpener;
class ViewGrid;
class Workspace;

/// Goes from one point in time of a series to another. Each point is a study with a session of its
/// own and is opened as any other study, so what was drawn stays with its point. What the user
/// looks at is carried over: crosshair, grey scale, position and zoom of the views and, to a point
/// that was never opened before, also the look of the 3D view. The views keep their pictures until
/// those of the next point arrive. GUI thread.
class TimeSteps : public QObject {
    Q_OBJECT

public:
    /// Construct it after @p display, which must be notified of a new session first. All must
    /// outlive this.
    TimeSteps(Workspace& workspace, StudyOpener& opener, DisplayState& display, ViewGrid& views,
        QObject* parent = nullptr);

    /// Whether there is a point this many points later; negative: earlier.
    [[nodiscard]] bool hasPoint(int later) const;
    /// Opens that point. Does nothing while a study is being opened.
    void go(int later);
    /// Opens a point.
    /// @param time counted from 0
    void openPoint(int time);
    /// Opens one point after the other, and the first after the last. Each stays open for 1 / @p
    /// pointsPerSecond, or longer if the session is not idle, a mouse button is down, or a menu or
    /// dialog is open. Playing ends with pause(), another study, a point that cannot be opened, or
    /// a new row of the history: what the user has begun is not taken away.
    void play(double pointsPerSecond);
    void pause();
    [[nodiscard]] bool isPlaying() const { return m_isPlaying; }

Q_SIGNALS:
    void playingChanged(bool isPlaying);

private:
    void holdPictures();
    void takeAlong();
    void finishOpening();
    void playOn();
    [[nodiscard]] std::size_t rows() const;

    Workspace& m_workspace;
    StudyOpener& m_opener;
    DisplayState& m_display;
    ViewGrid& m_views;
    QString m_awaited; ///< series key of the point that is being opened; empty: none
    QString m_awaitedText; ///< which point that is, in words
    QJsonObject m_look; ///< what the user looked at in the point before
    GrowSettings m_growth; ///< of that point in time; its box is kept at the next one
    bool m_isPlaying = false;
    std::size_t m_rowsAtFirst = 0; ///< number of the history's rows when the point was opened
    QTimer m_next;
};

} // namespace ui

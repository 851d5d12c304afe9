// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QTimer>

#include <cstddef>

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
    /// Opens one point after the other, and after the last the first, each for as long or for as
    /// long as it takes to open it. It ends with pause(), with another study, with a point that
    /// cannot be opened, and with the first row that is made: what was begun is not taken away.
    void play(double pointsPerSecond);
    void pause();
    [[nodiscard]] bool isPlaying() const { return m_isPlaying; }

Q_SIGNALS:
    void playingChanged(bool isPlaying);

private:
    void takeAlong();
    void finishOpening();
    void playOn();
    [[nodiscard]] std::size_t rows() const;

    Workspace& m_workspace;
    StudyOpener& m_opener;
    DisplayState& m_display;
    QString m_awaited; ///< key of the point that is being opened; empty: none
    QJsonObject m_look; ///< of the point before it
    bool m_isPlaying = false;
    std::size_t m_rowsAtFirst = 0; ///< of the point that is being played
    QTimer m_next;
};

} // namespace ui

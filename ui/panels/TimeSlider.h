// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QMenu;
class QPoint;
class QPushButton;
class QSlider;

namespace ui {

class Workspace;

/// The points in time of the open series: a slider that chooses one, with a button that opens it.
/// The slider's menu leads to both ends, plays the points one after the other and copies which one
/// is chosen. Hidden while the series has one point only.
class TimeSlider : public QWidget {
    Q_OBJECT

public:
    explicit TimeSlider(Workspace& workspace, QWidget* parent = nullptr);

    void showVolume();
    /// Whether the menu offers to stop instead of to play.
    void showPlaying(bool isPlaying);

Q_SIGNALS:
    void requested(int time); ///< another point, 0-based
    void playRequested(double pointsPerSecond);
    void pauseRequested();

private:
    void showChoice();
    void openMenu(const QPoint& at);
    void addSpeeds(QMenu& menu);
    /// "Point 3 of 10, trigger time 80 ms."
    [[nodiscard]] QString chosenText() const;

    Workspace& m_workspace;
    QLabel* m_text;
    QSlider* m_slider;
    QPushButton* m_open;
    bool m_isPlaying = false;
    double m_pointsPerSecond = 1.0;
};

} // namespace ui

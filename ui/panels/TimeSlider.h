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

/// A slider over the points in time of the open series, and a button that opens the chosen one. The
/// slider's context menu opens the first or last point, plays the points one after the other, and
/// copies the name of the chosen point. Hidden if the series has only one point.
class TimeSlider : public QWidget {
    Q_OBJECT

public:
    explicit TimeSlider(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows the points of the open series. Call it when another volume is open.
    void showVolume();
    /// Sets whether the points are being played; the menu then offers "Pause".
    void showPlaying(bool isPlaying);
    /// How fast the menu plays the points, as the user chose it.
    [[nodiscard]] double pointsPerSecond() const { return m_pointsPerSecond; }

Q_SIGNALS:
    void requested(int time); ///< the user asks for another point, counted from 0
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

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>
#include <QString>
#include <QWidget>

#include <vector>

namespace ui {

/// One mouse or pen event as it came from the system, including synthesised ones.
struct RawPointerEvent {
    QString kind; ///< "press", "move", "hover", "release"
    QString device; ///< "Stylus 'Wacom Intuos Pro', eraser"
    bool pen = false;
    bool eraser = false;
    QPointF position; ///< on the canvas, logical pixels
    double pressure = 0.0; ///< as reported; NaN if the device reports that
    QPointF tiltDegrees;
    double rotationDegrees = 0.0;
    double wheel = 0.0; ///< an airbrush's, −1 … 1
    Qt::MouseButtons buttons;
    Qt::KeyboardModifiers modifiers;
    quint64 milliseconds = 0; ///< the event's own time
};

/// A widget to scribble on that reports every event it gets. Strokes are as wide as the pressure.
class PointerCanvas : public QWidget {
    Q_OBJECT

public:
    explicit PointerCanvas(QWidget* parent = nullptr);

    void clear();

    [[nodiscard]] QSize sizeHint() const override { return {560, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 160}; }

Q_SIGNALS:
    void arrived(const ui::RawPointerEvent& event);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Dab {
        QPointF from;
        QPointF to;
        double pressure = 0.0;
        bool pen = false;
        bool eraser = false;
    };
    void take(const RawPointerEvent& event);

    std::vector<Dab> m_dabs;
    RawPointerEvent m_last;
    bool m_down = false;
};

} // namespace ui

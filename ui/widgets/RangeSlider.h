// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace ui {

/// A thin horizontal slider with two handles that never pass each other. A press moves the nearer
/// handle there; arrow keys move the handle that moved last, with Shift ten times as far. The wheel
/// is left to the surrounding scroll area.
class RangeSlider : public QWidget {
    Q_OBJECT

public:
    explicit RangeSlider(QWidget* parent = nullptr);

    /// Sets the range and the least distance of the handles, which is also the step of the arrow
    /// keys.
    void setBounds(double minimum, double maximum, double leastSpan);
    void setValues(double lower, double upper);
    [[nodiscard]] double lower() const { return m_values[0]; }
    [[nodiscard]] double upper() const { return m_values[1]; }

    [[nodiscard]] double xOf(double value) const;
    [[nodiscard]] QSize sizeHint() const override { return {140, 24}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {60, 24}; }

Q_SIGNALS:
    /// Emitted only for changes by the user.
    void valuesEdited(double lower, double upper);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void moveHandle(int handle, double value);
    [[nodiscard]] double valueAt(double x) const;

    double m_minimum = 0.0;
    double m_maximum = 1.0;
    double m_leastSpan = 0.0;
    double m_values[2] = {0.0, 1.0};
    int m_active = 0;
    bool m_dragging = false;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractSlider>

namespace ui {

/// A thin horizontal slider with a tick per step, if there is room for them, and a line of text
/// above it. A press moves the handle there; the wheel is left to the surrounding scroll area. It
/// reports over which step the pointer is.
class StepSlider : public QAbstractSlider {
    Q_OBJECT

public:
    explicit StepSlider(QWidget* parent = nullptr);

    [[nodiscard]] const QString& caption() const { return m_caption; }
    void setCaption(const QString& caption);

    /// The x position of a value on the groove, in pixels from the left.
    [[nodiscard]] double xOf(int value) const;

    [[nodiscard]] QSize sizeHint() const override { return {240, 40}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 40}; }

Q_SIGNALS:
    void hovered(int value);
    void left();

protected:
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    [[nodiscard]] int valueAt(double x) const;

    QString m_caption;
};

} // namespace ui

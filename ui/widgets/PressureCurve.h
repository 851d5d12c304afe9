// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace ui {

/// Edits how a pen's pressure sets the depth of a cut: the fraction of the depth is pressure to an
/// integer power, drawn as a curve. A click or drag chooses the curve that is nearest to the
/// pointer.
class PressureCurve : public QWidget {
    Q_OBJECT

public:
    static constexpr int greatestExponent = 3;

    explicit PressureCurve(QWidget* parent = nullptr);

    [[nodiscard]] int exponent() const { return m_exponent; }
    void setExponent(int exponent); ///< 1 … greatestExponent

    [[nodiscard]] QSize sizeHint() const override { return {220, 150}; }

Q_SIGNALS:
    void exponentChosen(int exponent);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF plot() const;
    void choose(const QPointF& position);
    void take(int exponent);

    int m_exponent = 2;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"
#include "ui/widgets/HistogramPlot.h"

#include <optional>

namespace ui {

/// Edits colour and opacity as functions of the value, as points on the histogram. Dragging moves a
/// point, a double click on empty ground adds one, a double click on a point asks for its colour,
/// and Delete removes the chosen one. Heights are square roots of the opacity per millimetre, so
/// that faint tissues can be distinguished.
class TransferFunctionEditor : public HistogramPlot {
    Q_OBJECT

public:
    explicit TransferFunctionEditor(QWidget* parent = nullptr);

    void setUnit(const QString& unit);
    void setFunction(const gpu::TransferFunction& function);
    [[nodiscard]] const gpu::TransferFunction& function() const { return m_function; }

    [[nodiscard]] QSize sizeHint() const override { return {240, 96}; }
    /// Where a point is drawn, in logical pixels.
    [[nodiscard]] QPointF positionOf(const gpu::TransferFunction::Point& point) const;

Q_SIGNALS:
    void functionEdited(const gpu::TransferFunction& function); ///< by the user

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] std::optional<std::size_t> pointAt(const QPointF& position) const;
    [[nodiscard]] double opacityAt(double y) const;
    void movePoint(std::size_t point, double value, double opacity);
    void notifyEdited();

    gpu::TransferFunction m_function;
    QString m_unit;
    std::optional<std::size_t> m_chosen;
    bool m_dragging = false;
};

} // namespace ui

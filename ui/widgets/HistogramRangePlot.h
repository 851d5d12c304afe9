// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/widgets/HistogramPlot.h"

#include <optional>
#include <utility>
#include <vector>

namespace ui {

/// The plot of HistogramRange. Arrow keys move the handle that was used last by the value of one
/// pixel; Escape cancels a drag.
class HistogramRangePlot : public HistogramPlot {
    Q_OBJECT

public:
    explicit HistogramRangePlot(QWidget* parent = nullptr);

    void setRange(double lower, double upper);
    void setMarkers(const std::vector<double>& values);
    /// Sets ranges within the interval that are drawn separately.
    /// @param stronger one that is emphasised
    void setBands(const std::vector<std::pair<double, double>>& bands,
        const std::optional<std::pair<double, double>>& stronger);

Q_SIGNALS:
    void rangeDragged(double lower, double upper);
    void released(); ///< the handles were released; also after each key
    void cancelled(); ///< Escape was pressed: the handles are where they were before the drag

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Grip { None, Lower, Upper, Both };
    [[nodiscard]] Grip gripAt(double x) const;
    void move(Grip grip, double lower, double upper);
    void paintBands(QPainter& painter) const;

    double m_lower = 0.0;
    double m_upper = 0.0;
    std::vector<double> m_markers;
    std::vector<std::pair<double, double>> m_bands;
    std::optional<std::pair<double, double>> m_strongerBand;
    Grip m_grip = Grip::None;
    Grip m_lastGrip = Grip::Upper;
    double m_pressX = 0.0;
    double m_pressLower = 0.0;
    double m_pressUpper = 0.0;
};

} // namespace ui

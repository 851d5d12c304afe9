// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

class QDoubleSpinBox;
class QGridLayout;

namespace ui {

class HistogramRangePlot;

/// Edits an interval of values on a histogram: two handles to drag, the range between them to
/// shift, and two fields for exact numbers with the unit. The lower bound never exceeds the upper
/// one.
class HistogramRange : public QWidget {
    Q_OBJECT

public:
    explicit HistogramRange(QWidget* parent = nullptr);

    /// @param unit stands behind the numbers; may be empty
    void setHistogram(const core::Histogram& histogram, const QString& unit);
    void setRange(double lower, double upper);
    [[nodiscard]] double lower() const { return m_lower; }
    [[nodiscard]] double upper() const { return m_upper; }
    /// Shows values of seeds as ticks at the bottom of the histogram.
    void setMarkers(const std::vector<double>& values);
    /// Shows, on the histogram, the ranges to which another criterion narrows the interval.
    /// @param stronger a range among them that is emphasised
    void setBands(const std::vector<std::pair<double, double>>& bands,
        const std::optional<std::pair<double, double>>& stronger);
    /// Places a widget between the two numbers; takes ownership.
    void setMiddleWidget(QWidget* widget);
    /// Zooms so that the range around the interval fills the width.
    void zoomToRange();
    /// Does so if the handles are out of sight or too close to each other.
    void showRange();

    [[nodiscard]] HistogramRangePlot* plot() const { return m_plot; }

Q_SIGNALS:
    /// The user has changed the interval; also emitted while dragging.
    void rangeEdited(double lower, double upper);
    /// The user has finished a change; also emitted after each number that was typed.
    void rangeSettled();
    /// The user has cancelled a drag: the interval is again what it was before.
    void rangeCancelled();

private:
    void take(double lower, double upper);

    double m_lower = 0.0;
    double m_upper = 0.0;
    HistogramRangePlot* m_plot = nullptr;
    QDoubleSpinBox* m_lowerBox = nullptr;
    QDoubleSpinBox* m_upperBox = nullptr;
    QGridLayout* m_layout = nullptr;
};

} // namespace ui

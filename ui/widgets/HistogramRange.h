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

/// An interval of values on a histogram: two handles to drag, the stretch between them to shift,
/// and two fields for exact numbers with the unit. The interval is never upside down.
class HistogramRange : public QWidget {
    Q_OBJECT

public:
    explicit HistogramRange(QWidget* parent = nullptr);

    /// @param unit stands behind the numbers; may be empty
    void setHistogram(const core::Histogram& histogram, const QString& unit);
    void setRange(double lower, double upper);
    [[nodiscard]] double lower() const { return m_lower; }
    [[nodiscard]] double upper() const { return m_upper; }
    /// Values of seeds, as ticks on the histogram's foot.
    void setMarkers(const std::vector<double>& values);
    /// What the interval is narrowed to by something else, on the histogram. @param stronger a
    /// part of it that stands out
    void setBands(const std::vector<std::pair<double, double>>& bands,
        const std::optional<std::pair<double, double>>& stronger);
    /// Stands between the two numbers; taken over.
    void setMiddleWidget(QWidget* widget);
    /// The part of the histogram around the interval fills the width.
    void zoomToRange();
    /// Does so where the handles are out of sight or lie on top of each other.
    void showRange();

    [[nodiscard]] HistogramRangePlot* plot() const { return m_plot; }

Q_SIGNALS:
    /// By the user, while dragging too.
    void rangeEdited(double lower, double upper);
    /// By the user: done for now. After each number that was typed too.
    void rangeSettled();
    /// By the user: the interval is again what it was before it was dragged.
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

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QWidget>

namespace ui {

/// Draws a volume's histogram (logarithmic counts) with values along x, as the background for
/// interval handles and transfer functions. Ctrl and the wheel zoom at the cursor, and so does the
/// wheel alone once the plot has the focus; otherwise it scrolls the panel. A double click on empty
/// ground shows the whole range again.
class HistogramPlot : public QWidget {
    Q_OBJECT

public:
    explicit HistogramPlot(QWidget* parent = nullptr);

    void setHistogram(const core::Histogram& histogram);
    [[nodiscard]] const core::Histogram& histogram() const { return m_histogram; }
    /// Sets the range of values that is shown, clamped to the histogram's range.
    void showValues(double from, double to);

    [[nodiscard]] double xOf(double value) const;
    [[nodiscard]] double valueAt(double x) const;
    /// The value at x, rounded to as many digits as a pixel resolves.
    [[nodiscard]] double roundedValueAt(double x) const;

    [[nodiscard]] QSize sizeHint() const override { return {240, 72}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 48}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

    /// The area of the plot inside the frame.
    [[nodiscard]] QRectF plotArea() const;
    void showAll();

private:
    core::Histogram m_histogram;
    double m_from = 0.0;
    double m_to = 1.0;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QWidget>

namespace ui {

/// A volume's histogram (logarithmic counts) with values along x: the ground that interval handles
/// and transfer functions are drawn on. The wheel zooms at the cursor, a double click on empty
/// ground shows the whole range again.
class HistogramPlot : public QWidget {
    Q_OBJECT

public:
    explicit HistogramPlot(QWidget* parent = nullptr);

    void setHistogram(const core::Histogram& histogram);
    [[nodiscard]] const core::Histogram& histogram() const { return m_histogram; }
    /// The stretch of values that is shown, kept inside the histogram's range.
    void showValues(double from, double to);

    [[nodiscard]] double xOf(double value) const;
    [[nodiscard]] double valueAt(double x) const;
    /// The value whose readout has no more digits than a pixel is worth.
    [[nodiscard]] double roundedValueAt(double x) const;

    [[nodiscard]] QSize sizeHint() const override { return {240, 72}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 48}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

    /// Where the picture is, inside the frame.
    [[nodiscard]] QRectF plotArea() const;
    void showAll();

private:
    core::Histogram m_histogram;
    double m_from = 0.0;
    double m_to = 1.0;
};

} // namespace ui

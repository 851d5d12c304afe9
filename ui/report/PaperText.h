// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QString>
#include <QTextLayout>

#include <memory>

class QPainter;

namespace ui {

/// A text set in a column on paper: lines break between words, or inside words that are longer than
/// a line.
class PaperText {
public:
    struct Style {
        double sizePoints = 8.5;
        QColor colour{0x1b, 0x1f, 0x24};
        bool bold = false;
        bool fixedPitch = false;
        Qt::Alignment alignment = Qt::AlignLeft;
        qsizetype longest = 300; ///< greatest number of letters, so that every row fits on a page
    };

    /// @param width in pixels
    /// @param pixelsPerPoint of the paper
    PaperText(const QString& text, double width, double pixelsPerPoint, const Style& style);

    [[nodiscard]] double height() const { return m_height; }
    [[nodiscard]] double longestLine() const { return m_longestLine; }
    void paint(QPainter& painter, const QPointF& topLeft) const;

private:
    std::shared_ptr<QTextLayout> m_layout;
    QColor m_colour;
    double m_height = 0.0;
    double m_longestLine = 0.0;
};

} // namespace ui

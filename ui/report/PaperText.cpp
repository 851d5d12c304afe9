// SPDX-License-Identifier: Apache-2.0
#include "ui/report/PaperText.h"

#include <QPainter>
#include <QTextOption>

#include <algorithm>

namespace ui {

namespace {

constexpr double lineSpacing = 1.12; ///< of the font's own

QFont fontOf(const PaperText::Style& style, double pixelsPerPoint)
{
    QFont font;
    font.setFamilies(style.fixedPitch
            ? QStringList{QStringLiteral("DejaVu Sans Mono"), QStringLiteral("monospace")}
            : QStringList{QStringLiteral("Inter"), QStringLiteral("sans-serif")});
    font.setPixelSize(std::max(1, qRound(style.sizePoints * pixelsPerPoint)));
    font.setWeight(style.bold ? QFont::DemiBold : QFont::Normal);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

} // namespace

PaperText::PaperText(const QString& text, double width, double pixelsPerPoint, const Style& style)
    : m_colour(style.colour)
{
    QString shown = text.size() > style.longest ? text.left(style.longest) + u'…' : text;
    shown.replace(u'\n', QChar::LineSeparator);
    m_layout = std::make_shared<QTextLayout>(shown, fontOf(style, pixelsPerPoint));
    QTextOption option(style.alignment);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    m_layout->setTextOption(option);
    m_layout->beginLayout();
    for (QTextLine line = m_layout->createLine(); line.isValid(); line = m_layout->createLine()) {
        line.setLineWidth(width);
        line.setPosition({0.0, m_height});
        m_height += line.height() * lineSpacing;
        m_longestLine = std::max(m_longestLine, line.naturalTextWidth());
    }
    m_layout->endLayout();
}

void PaperText::paint(QPainter& painter, const QPointF& topLeft) const
{
    painter.setPen(m_colour);
    m_layout->draw(&painter, topLeft);
}

} // namespace ui

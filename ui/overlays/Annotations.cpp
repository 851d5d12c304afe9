// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/Annotations.h"

#include "ui/base/Theme.h"
#include "ui/geometry/OrientationLetters.h"

#include <QFont>
#include <QFontMetrics>
#include <QFontMetricsF>
#include <QPainter>
#include <QStyle>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ui {

namespace {

constexpr double crosshairGap = 14.0; // pixels

constexpr int lineHeight = 17;
constexpr int topMargin = 9;
constexpr int bottomMargin = 9;
constexpr int textRim = 4; ///< pixels at either side of a text that lines leave free

/// A text as it is drawn.
struct PlacedText {
    QRectF box;
    Qt::Alignment side;
    QString text;
    QColor colour;
    QFont font;
};

void placeLines(std::vector<PlacedText>& placed, const QRect& view, int firstY, int step,
    Qt::Alignment side, const QStringList& lines, double width)
{
    const QFont font = theme::smallFont();
    const QFontMetricsF metrics(font);
    int y = firstY;
    for (const QString& line : lines) {
        if (line.isEmpty())
            continue;
        placed.push_back({.box = QRectF(view.left() + theme::padding, y,
                              view.width() - 2 * theme::padding, lineHeight),
            .side = side | Qt::AlignVCenter,
            .text = metrics.elidedText(line, Qt::ElideRight, width),
            .colour = theme::text,
            .font = font});
        y += step;
    }
}

std::vector<PlacedText> placedCorners(const QRect& view, const CornerTexts& texts)
{
    const double half = view.width() / 2.0 - theme::padding - 24;
    const int top = view.top() + topMargin;
    const int bottom = view.bottom() + 1 - bottomMargin - lineHeight;
    std::vector<PlacedText> placed{
        {.box = QRectF(view.left() + theme::padding, top, half, lineHeight),
            .side = Qt::AlignLeft | Qt::AlignVCenter,
            .text = texts.title,
            .colour = texts.titleColour,
            .font = theme::headingFont()}};
    placeLines(placed, view, top + lineHeight, lineHeight, Qt::AlignLeft, texts.topLeft, half);
    placeLines(placed, view, top, lineHeight, Qt::AlignRight, texts.topRight, half);
    placeLines(placed, view, bottom, -lineHeight, Qt::AlignLeft, texts.bottomLeft, half);
    placeLines(placed, view, bottom, -lineHeight, Qt::AlignRight, texts.bottomRight, half);
    return placed;
}

std::vector<PlacedText> placedLetters(
    const QRect& view, const glm::dvec3& rightLps, const glm::dvec3& downLps)
{
    QFont font = theme::bodyFont();
    font.setWeight(QFont::Bold);
    constexpr double box = 44.0;
    constexpr double inset = 8.0;
    const QRectF frame(view);
    const QPointF middle = frame.center();
    std::vector<PlacedText> placed;
    const auto place = [&](double x, double y, Qt::Alignment side, const glm::dvec3& direction) {
        placed.push_back({.box = QRectF(x, y, box, box),
            .side = side,
            .text = directionLetters(direction),
            .colour = theme::text,
            .font = font});
    };
    place(frame.left() + inset, middle.y() - box / 2, Qt::AlignLeft | Qt::AlignVCenter, -rightLps);
    place(frame.right() - inset - box, middle.y() - box / 2, Qt::AlignRight | Qt::AlignVCenter,
        rightLps);
    place(middle.x() - box / 2, frame.top() + inset + theme::viewBarHeight - 2,
        Qt::AlignHCenter | Qt::AlignTop, -downLps);
    place(middle.x() - box / 2, frame.bottom() - inset - box, Qt::AlignHCenter | Qt::AlignBottom,
        downLps);
    return placed;
}

void paintPlaced(QPainter& painter, const std::vector<PlacedText>& texts)
{
    painter.save();
    for (const PlacedText& each : texts) {
        painter.setFont(each.font);
        paintText(painter, each.box, int(each.side), each.text, each.colour);
    }
    painter.restore();
}

QRegion regionOf(const std::vector<PlacedText>& texts)
{
    QRegion region;
    for (const PlacedText& each : texts) {
        if (each.text.isEmpty())
            continue;
        const QFontMetrics metrics(each.font);
        const QSize size(metrics.horizontalAdvance(each.text), metrics.height());
        const QRect tight =
            QStyle::alignedRect(Qt::LeftToRight, each.side, size, each.box.toAlignedRect());
        region += tight.adjusted(-textRim, -1, textRim, 1);
    }
    return region;
}

} // namespace

QColor sliceColour(SliceOrientation orientation)
{
    switch (orientation) {
    case SliceOrientation::Axial:
        return theme::axial;
    case SliceOrientation::Sagittal:
        return theme::sagittal;
    case SliceOrientation::Coronal:
        break;
    }
    return theme::coronal;
}

void paintText(
    QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& colour)
{
    // A rim all around: the ground may be white bone as well as air.
    painter.setPen(QColor(0, 0, 0, 190));
    for (const QPointF& offset : {QPointF(1.2, 0), QPointF(-1.2, 0), QPointF(0, 1.2),
             QPointF(0, -1.2), QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)})
        painter.drawText(box.translated(offset), flags | Qt::TextDontClip, text);
    painter.setPen(colour);
    painter.drawText(box, flags | Qt::TextDontClip, text);
}

void paintCorners(QPainter& painter, const QRect& view, const CornerTexts& texts)
{
    paintPlaced(painter, placedCorners(view, texts));
}

QRegion cornersRegion(const QRect& view, const CornerTexts& texts)
{
    return regionOf(placedCorners(view, texts));
}

void paintEdgeLetters(
    QPainter& painter, const QRect& view, const glm::dvec3& rightLps, const glm::dvec3& downLps)
{
    paintPlaced(painter, placedLetters(view, rightLps, downLps));
}

QRegion edgeLettersRegion(const QRect& view, const glm::dvec3& rightLps, const glm::dvec3& downLps)
{
    return regionOf(placedLetters(view, rightLps, downLps));
}

double scaleBarLengthMm(double mmPerPixel, double maximumPixels)
{
    const double longest = mmPerPixel * maximumPixels;
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    for (const double multiple : {5.0, 2.0}) {
        if (multiple * power <= longest)
            return multiple * power;
    }
    return power;
}

void paintScaleBar(QPainter& painter, const QRect& view, int baseline, double mmPerPixel)
{
    const double mm = scaleBarLengthMm(mmPerPixel, 110.0);
    const double pixels = mm / mmPerPixel;
    const double right = view.right() + 1 - theme::padding;
    painter.save();
    painter.setFont(theme::smallFont());
    const QString text =
        mm >= 10.0 ? QStringLiteral("%1 cm").arg(mm / 10.0) : QStringLiteral("%1 mm").arg(mm);
    paintText(painter, QRectF(right - pixels, baseline - 20, pixels, 16),
        Qt::AlignHCenter | Qt::AlignVCenter, text, theme::text);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(QRectF(right - pixels - 1, baseline - 3, pixels + 2, 4), QColor(0, 0, 0, 160));
    painter.fillRect(QRectF(right - pixels, baseline - 2, pixels, 2), theme::text);
    painter.restore();
}

void paintCrosshairLine(QPainter& painter, const QRect& view, const QPointF& centre,
    const QPointF& direction, const QColor& colour)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor soft = colour;
    soft.setAlpha(210);
    QPen pen(soft, 1.2);
    pen.setDashPattern({5.0, 4.0});
    painter.setPen(pen);
    const double far = std::hypot(view.width(), view.height()) + 1e-3;
    // As far as the picture may be away from the crosshair, but no farther than a painter draws.
    const double away = std::hypot(centre.x(), centre.y());
    for (const double side : {-1.0, 1.0})
        painter.drawLine(centre + side * crosshairGap * direction,
            centre + side * std::min(far + away, 1e5) * direction);
    painter.restore();
}

void paintCrosshair(QPainter& painter, const QRect& view, const QPointF& centre,
    const QColor& horizontal, const QColor& vertical)
{
    constexpr double gap = crosshairGap;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    const auto line = [&](QColor colour, const QPointF& from, const QPointF& to) {
        colour.setAlpha(210);
        QPen pen(colour, 1.0);
        pen.setDashPattern({5.0, 4.0});
        painter.setPen(pen);
        painter.drawLine(from, to);
    };
    // Lines start at the gap, so that the dashes stand still while the crosshair rests.
    const QPointF at(std::floor(centre.x()) + 0.5, std::floor(centre.y()) + 0.5);
    if (at.y() >= view.top() && at.y() <= view.bottom()) {
        line(horizontal, {at.x() - gap, at.y()}, {double(view.left()), at.y()});
        line(horizontal, {at.x() + gap, at.y()}, {double(view.right()), at.y()});
    }
    if (at.x() >= view.left() && at.x() <= view.right()) {
        line(vertical, {at.x(), at.y() - gap}, {at.x(), double(view.top())});
        line(vertical, {at.x(), at.y() + gap}, {at.x(), double(view.bottom())});
    }
    painter.restore();
}

} // namespace ui

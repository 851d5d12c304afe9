// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/Stereo.h"

#include <QPainter>

namespace ui {

namespace {

QImage anaglyph(const QImage& left, const QImage& right)
{
    constexpr int channels = 4;
    QImage both = right.convertToFormat(QImage::Format_RGBX8888);
    const QImage red = left.convertToFormat(QImage::Format_RGBX8888);
    for (int y = 0; y < both.height(); ++y) {
        uchar* to = both.scanLine(y);
        const uchar* from = red.constScanLine(y);
        for (int x = 0; x < both.width(); ++x)
            to[channels * x] = from[channels * x];
    }
    return both;
}

QImage sideBySide(const QImage& left, const QImage& right)
{
    QImage both(left.size(), QImage::Format_RGBX8888);
    QPainter painter(&both);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const double half = 0.5 * left.width();
    painter.drawImage(QRectF(0.0, 0.0, half, left.height()), left);
    painter.drawImage(QRectF(half, 0.0, half, left.height()), right);
    return both;
}

} // namespace

QImage composed(Stereo::Mode mode, const QImage& left, const QImage& right)
{
    if (mode == Stereo::Mode::Off || left.size() != right.size())
        return left;
    return mode == Stereo::Mode::Anaglyph ? anaglyph(left, right) : sideBySide(left, right);
}

} // namespace ui

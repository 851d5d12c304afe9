// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/Collage.h"

#include <QDir>
#include <QPainter>
#include <QWidget>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace test {

namespace {

constexpr int gapPixels = 8;
constexpr std::uint32_t windowRgb = 0x16181C;

/// What pixels of about one colour come to.
struct ColourBin {
    std::array<std::int64_t, 3> sum{};
    std::int64_t count = 0;
    [[nodiscard]] int channel(std::size_t at) const { return int(sum[at] / count); }
    [[nodiscard]] QRgb rgb() const { return qRgb(channel(0), channel(1), channel(2)); }
};

std::size_t binOf(QRgb colour)
{
    return std::size_t(qRed(colour) >> 3 << 10 | qGreen(colour) >> 3 << 5 | qBlue(colour) >> 3);
}

int distanceOf(QRgb first, QRgb second)
{
    const auto square = [](int value) { return value * value; };
    return square(qRed(first) - qRed(second)) + square(qGreen(first) - qGreen(second))
        + square(qBlue(first) - qBlue(second));
}

/// With the colours that are in it most often; others become the nearest of them.
QImage withFewColours(const QImage& picture)
{
    std::vector<ColourBin> bins(std::size_t(1) << 15);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb colour = picture.pixel(x, y);
            ColourBin& bin = bins[binOf(colour)];
            bin.sum[0] += qRed(colour);
            bin.sum[1] += qGreen(colour);
            bin.sum[2] += qBlue(colour);
            ++bin.count;
        }
    }
    std::vector<std::size_t> often;
    for (std::size_t at = 0; at < bins.size(); ++at) {
        if (bins[at].count > 0)
            often.push_back(at);
    }
    const auto end = often.begin() + std::ptrdiff_t(std::min<std::size_t>(256, often.size()));
    std::partial_sort(often.begin(), end, often.end(), [&bins](std::size_t a, std::size_t b) {
        return std::pair(-bins[a].count, a) < std::pair(-bins[b].count, b);
    });
    QList<QRgb> table;
    for (auto at = often.begin(); at != end; ++at)
        table.append(bins[*at].rgb());
    std::vector<uchar> nearest(bins.size());
    for (const std::size_t at : often) {
        int least = std::numeric_limits<int>::max();
        for (int i = 0; i < table.size(); ++i) {
            if (const int away = distanceOf(bins[at].rgb(), table[i]); away < least) {
                least = away;
                nearest[at] = uchar(i);
            }
        }
    }
    QImage few(picture.size(), QImage::Format_Indexed8);
    few.setColorTable(table);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x)
            few.scanLine(y)[x] = nearest[binOf(picture.pixel(x, y))];
    }
    return few;
}

} // namespace

QImage middleOf(QWidget& shown, const QSize& size)
{
    const QImage all = shown.grab().toImage();
    const QSize part = size.boundedTo(all.size());
    return all.copy((all.width() - part.width()) / 2, (all.height() - part.height()) / 2,
        part.width(), part.height());
}

bool keepCollage(const std::vector<std::vector<QImage>>& rows, const char* name)
{
    QSize all(0, -gapPixels);
    std::vector<int> heights;
    for (const std::vector<QImage>& row : rows) {
        int width = -gapPixels;
        int height = 0;
        for (const QImage& picture : row) {
            width += picture.width() + gapPixels;
            height = std::max(height, picture.height());
        }
        heights.push_back(height);
        all = QSize(std::max(all.width(), width), all.height() + height + gapPixels);
    }
    QImage whole(all, QImage::Format_RGB32);
    whole.fill(windowRgb);
    QPainter painter(&whole);
    int y = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        int x = 0;
        for (const QImage& picture : rows[i]) {
            painter.drawImage(x, y + (heights[i] - picture.height()) / 2, picture);
            x += picture.width() + gapPixels;
        }
        y += heights[i] + gapPixels;
    }
    painter.end();
    return withFewColours(whole).save(
        QDir(qEnvironmentVariable("BURIN_SCREENSHOTS")).filePath(QLatin1String(name)));
}

} // namespace test

// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/ColourBar.h"

#include "ui/base/Theme.h"
#include "ui/overlays/Annotations.h"

#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr int barWidth = 8;
constexpr int fromLetter = 26; // from the middle of the view, where the letter is
constexpr int fromBottom = 70; // slice number and scale bar
constexpr int leastHeight = 36; // both texts stay apart
constexpr int greatestHeight = 160;

} // namespace

QRect colourBarPlace(const QRect& view)
{
    const int top = view.top() + view.height() / 2 + fromLetter;
    const int height = std::min(view.bottom() + 1 - fromBottom - top, greatestHeight);
    if (height < leastHeight)
        return {};
    return {view.right() + 1 - theme::padding - barWidth, top, barWidth, height};
}

void paintColourBar(QPainter& painter, const QRect& view, const ColourBar& bar)
{
    const QRect place = colourBarPlace(view);
    if (place.isEmpty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(place.adjusted(-1, -1, 1, 1), QColor(0, 0, 0, 160));
    const gpu::ColourEntries& entries = gpu::entriesOf(bar.map);
    for (int row = 0; row < place.height(); ++row) {
        const int up = (place.height() - 1 - row) * 255 / (place.height() - 1);
        const std::uint32_t rgb = entries[std::size_t(bar.inverted ? 255 - up : up)];
        painter.fillRect(place.left(), place.top() + row, place.width(), 1, QColor(QRgb(rgb)));
    }
    painter.setFont(theme::smallFont());
    const QRectF text(place.left() - 126, place.top() - 2, 120, 16);
    paintText(painter, text, Qt::AlignRight | Qt::AlignVCenter, bar.upper, theme::text);
    paintText(painter, text.translated(0, place.height() - 12), Qt::AlignRight | Qt::AlignVCenter,
        bar.lower, theme::text);
    painter.restore();
}

} // namespace ui

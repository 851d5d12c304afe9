// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/KeyframeRule.h"

#include <QBuffer>

#include <chrono>

namespace ui {

void KeyframeRule::begin(std::size_t rows, core::RowId position, bool anyPicture, qint64 now)
{
    m_rowsAtLast = rows;
    m_timeAtLast = now;
    m_lastKept = position; // closed at once, it needs no picture
    m_any = anyPicture;
}

bool KeyframeRule::dueAfterStep(std::size_t rows, qint64 now) const
{
    return !m_any || rows - m_rowsAtLast >= std::size_t(stepsBetween)
        || now - m_timeAtLast >= millisecondsBetween;
}

bool KeyframeRule::dueAtEnd(core::RowId position) const
{
    return position != m_lastKept && position != 0;
}

void KeyframeRule::kept(core::RowId row, std::size_t rows, qint64 now)
{
    m_any = true;
    m_rowsAtLast = rows;
    m_timeAtLast = now;
    m_lastKept = row;
}

qint64 steadyMilliseconds()
{
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

QByteArray keyframePng(const QImage& picture)
{
    const QImage small =
        picture.scaled(KeyframeRule::pictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    small.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG");
    return png;
}

} // namespace ui

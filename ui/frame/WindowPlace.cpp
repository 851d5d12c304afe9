// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/WindowPlace.h"

#include <QGuiApplication>
#include <QRegion>
#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace ui {

QRect placeWithin(const QRect& window, const QRect& available)
{
    const QRect room = available.adjusted(0, titleBarPixels, 0, 0);
    const QSize size = window.size().boundedTo(room.size());
    return {QPoint(std::clamp(window.x(), room.x(), room.x() + room.width() - size.width()),
                std::clamp(window.y(), room.y(), room.y() + room.height() - size.height())),
        size};
}

void bringOntoScreens(QWidget& window)
{
    if (window.isMaximized() || window.isFullScreen())
        return;
    QRegion screens;
    for (const QScreen* screen : QGuiApplication::screens())
        screens += screen->availableGeometry();
    if (!QRegion(window.geometry()).subtracted(screens).isEmpty())
        window.setGeometry(placeWithin(window.geometry(), window.screen()->availableGeometry()));
}

} // namespace ui

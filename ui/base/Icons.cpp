// SPDX-License-Identifier: Apache-2.0
#include "ui/base/Icons.h"

#include "ui/base/Theme.h"

#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

// Q_INIT_RESOURCE must stand outside any namespace.
static void initialiseResources()
{
    Q_INIT_RESOURCE(burin_window);
}

namespace ui {

void registerResources()
{
    initialiseResources();
}

QPixmap tintedIcon(const QString& name, const QColor& colour, int size, double devicePixelRatio)
{
    QFile file(QStringLiteral(":/burin/icons/%1.svg").arg(name));
    QByteArray drawing = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    drawing.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer renderer(drawing);
    QPixmap pixmap(QSize(size, size) * devicePixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    painter.end();
    pixmap.setDevicePixelRatio(devicePixelRatio);
    return pixmap;
}

QIcon stateIcon(const QString& name)
{
    QIcon icon;
    for (const double ratio : {1.0, 2.0}) {
        const auto add = [&](const QColor& colour, QIcon::Mode mode, QIcon::State state) {
            icon.addPixmap(tintedIcon(name, colour, theme::iconSize, ratio), mode, state);
        };
        add(theme::secondary, QIcon::Normal, QIcon::Off);
        add(theme::text, QIcon::Active, QIcon::Off);
        add(theme::accent, QIcon::Normal, QIcon::On);
        add(theme::accent, QIcon::Active, QIcon::On);
        add(QColor(0x4a, 0x50, 0x5a), QIcon::Disabled, QIcon::Off);
    }
    return icon;
}

} // namespace ui

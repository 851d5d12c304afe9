// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/RecentStudies.h"

#include <QFileInfo>
#include <QSettings>
#include <QVariantMap>

namespace ui {

namespace {

const QLatin1String recentKey("recentStudies");
const QLatin1String seriesKey("recentSeries");

} // namespace

QStringList RecentStudies::paths()
{
    QStringList present;
    for (const QString& path : QSettings().value(recentKey).toStringList()) {
        if (QFileInfo::exists(path))
            present += path;
    }
    return present;
}

void RecentStudies::add(const QString& path, const QString& series)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList list = paths();
    list.removeAll(absolute);
    list.prepend(absolute);
    list = list.mid(0, kept);
    QSettings settings;
    settings.setValue(recentKey, QVariant(list));
    const QVariantMap before = settings.value(seriesKey).toMap();
    QVariantMap now;
    for (const QString& each : list) {
        const QVariant known = each == absolute ? QVariant(series) : before.value(each);
        if (!known.toString().isEmpty())
            now.insert(each, known);
    }
    settings.setValue(seriesKey, now);
}

QString RecentStudies::seriesOf(const QString& path)
{
    return QSettings()
        .value(seriesKey)
        .toMap()
        .value(QFileInfo(path).absoluteFilePath())
        .toString();
}

} // namespace ui

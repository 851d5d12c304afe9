// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/RecentStudies.h"

#include <QFileInfo>
#include <QSettings>
#include <QVariantMap>

namespace ui {

namespace {

const QLatin1String recentKey("recentStudies");
const QLatin1String seriesKey("recentSeries");
/// More than are shown: some may lie on a drive that is not there at present.
constexpr int stored = 3 * RecentStudies::kept;

QStringList storedPaths()
{
    return QSettings().value(recentKey).toStringList();
}

} // namespace

QStringList RecentStudies::paths()
{
    QStringList present;
    for (const QString& path : storedPaths()) {
        if (present.size() < kept && QFileInfo::exists(path))
            present += path;
    }
    return present;
}

void RecentStudies::add(const QString& path, const QString& series)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList list = storedPaths();
    list.removeAll(absolute);
    list.prepend(absolute);
    list = list.mid(0, stored);
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

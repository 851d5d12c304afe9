// SPDX-License-Identifier: Apache-2.0
#include "ui/RecentStudies.h"

#include <QFileInfo>
#include <QSettings>

namespace ui {

namespace {

const QLatin1String settingsKey("recentStudies");

} // namespace

QStringList RecentStudies::paths()
{
    QStringList present;
    for (const QString& path : QSettings().value(settingsKey).toStringList()) {
        if (QFileInfo::exists(path))
            present += path;
    }
    return present;
}

void RecentStudies::add(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList list = paths();
    list.removeAll(absolute);
    list.prepend(absolute);
    QSettings().setValue(settingsKey, QVariant(list.mid(0, kept)));
}

} // namespace ui

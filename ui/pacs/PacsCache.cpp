// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/PacsCache.h"

#include "ui/workspace/Workspace.h"

#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace ui {

namespace {

const QString limitKey = QStringLiteral("pacs/cacheGibibytes");
constexpr int mostGibibytes = 10000;

} // namespace

core::DownloadCache pacsCache()
{
    return core::DownloadCache(
        QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/pacs"));
}

int cacheGibibytes()
{
    bool isNumber = false;
    const int kept = QSettings().value(limitKey).toInt(&isNumber);
    return isNumber ? std::clamp(kept, 1, mostGibibytes) : usualCacheGibibytes;
}

void setCacheGibibytes(int gibibytes)
{
    QSettings().setValue(limitKey, std::clamp(gibibytes, 1, mostGibibytes));
}

qint64 cacheLimitBytes()
{
    return qint64(cacheGibibytes()) << 30;
}

QString bytesText(qint64 bytes)
{
    constexpr double mega = 1e6;
    constexpr double giga = 1e9;
    if (double(bytes) < giga)
        return QStringLiteral("%1 MB").arg(double(bytes) / mega, 0, 'f', bytes < 10e6 ? 1 : 0);
    return QStringLiteral("%1 GB").arg(double(bytes) / giga, 0, 'f', 1);
}

CacheHolder::CacheHolder(Workspace& workspace)
    : QObject(&workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this, &workspace] {
        m_hold.reset();
        const core::Volume* volume = workspace.volume();
        const core::DownloadCache cache = pacsCache();
        const QString entry = volume ? cache.entryOf(volume->sourcePath) : QString();
        if (!entry.isEmpty())
            m_hold = cache.hold(entry);
    });
}

} // namespace ui

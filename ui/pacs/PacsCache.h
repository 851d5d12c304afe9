// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sources/DownloadCache.h"

#include <QObject>
#include <QString>

namespace ui {

class Workspace;

/// The local copies of downloads, and how much disk space they may take: settings of the user.
[[nodiscard]] core::DownloadCache pacsCache();
constexpr int usualCacheGibibytes = 20;
[[nodiscard]] int cacheGibibytes();
void setCacheGibibytes(int gibibytes);
[[nodiscard]] qint64 cacheLimitBytes();

/// "812 MB", "1.4 GB"
[[nodiscard]] QString bytesText(qint64 bytes);

/// Protects the copy that the open study came from against removal while it is open.
class CacheHolder : public QObject {
    Q_OBJECT

public:
    explicit CacheHolder(Workspace& workspace);

private:
    core::DownloadCache::Hold m_hold;
};

} // namespace ui

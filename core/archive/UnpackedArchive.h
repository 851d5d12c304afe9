// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <QString>

namespace core {

/// Where archives lie unpacked, in the user's cache. Settable for tests.
[[nodiscard]] QString archiveCacheFolder();
void setArchiveCacheFolder(const QString& folder);

/// What an archive holds, as a folder: unpacked when it is asked for the first time, found again as
/// long as the archive is the same (place, size, time of change).
///
/// A folder appears only whole. Those that this process has asked for stay until it ends; of the
/// others the ones least recently used go once all together take more than @p mostBytes.
/// Any thread. Errors: those of unpackArchive(), FileUnwritable.
[[nodiscard]] Result<QString> unpackedArchive(
    const QString& path, const Progress& progress, qint64 mostBytes = qint64(20) << 30);

} // namespace core

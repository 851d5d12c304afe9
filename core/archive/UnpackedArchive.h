// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <QString>

namespace core {

/// The folder in the user's cache that contains unpacked archives. Can be set for tests.
[[nodiscard]] QString archiveCacheFolder();
void setArchiveCacheFolder(const QString& folder);

/// The content of an archive as a folder. It is unpacked at the first request and found again as
/// long as the archive is the same (path, size, time of modification).
///
/// A folder appears only when it is complete and on the disk. Folders that this process has
/// requested are kept until it ends; of the others, the least recently used are removed when all
/// together exceed @p mostBytes. Any thread. Errors: those of unpackArchive(), FileUnwritable.
[[nodiscard]] Result<QString> unpackedArchive(
    const QString& path, const Progress& progress, qint64 mostBytes = qint64(20) << 30);

} // namespace core

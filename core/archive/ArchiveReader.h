// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <QString>

namespace core {

/// Whether a file is an archive of files: zip and 7z by their first bytes, tar (also packed) by its
/// name as well. Volumes that are packed by themselves (.nii.gz) are none.
[[nodiscard]] bool isArchive(const QString& path);

/// Writes all that an archive holds below @p folder, which must be there. Names stay as they are as
/// far as they lead nowhere else; links and devices are left out, folders are for their owner only.
///
/// Stops where an archive unpacks to more than a hundred times its own size and more than a
/// gigabyte, to more than the disk has room for, or to more files than a study has.
/// Any thread. Errors: FileUnreadable (also for a password), UnsupportedFormat, FileUnwritable,
/// Cancelled; all but the last name the archive.
[[nodiscard]] Result<void> unpackArchive(
    const QString& path, const QString& folder, const Progress& progress);

} // namespace core

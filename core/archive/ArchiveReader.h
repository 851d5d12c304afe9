// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <QString>

namespace core {

/// Whether a file is an archive of files: zip and 7z are recognised by their first bytes, tar (also
/// compressed) by its name as well. A compressed single volume (.nii.gz) is not an archive.
[[nodiscard]] bool isArchive(const QString& path);

/// Unpacks an archive into @p folder, which must exist. Names are kept as far as they stay inside
/// the folder; links and devices are left out; folders are accessible to their owner only.
///
/// Stops if the content exceeds a hundred times the size of the archive and a gigabyte, if it
/// exceeds the free space on the disk, or if there are more files than in any study. Any thread.
/// Errors: FileUnreadable (also for a password), UnsupportedFormat, FileUnwritable, Cancelled; all
/// but the last name the archive.
[[nodiscard]] Result<void> unpackArchive(
    const QString& path, const QString& folder, const Progress& progress);

} // namespace core

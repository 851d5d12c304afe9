// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/sessionfile/records/SessionSource.h"

#include <QString>
#include <QStringList>

namespace core {

/// Paths at which the study of a session may be now, most likely first; only paths that exist. The
/// first is the one where the study was when the session was made. Others are beside the session
/// file and beside its folder, so that a folder with both can be moved or copied as a whole: for
/// /data/case/ct.nii and /moved/case/s.burin, the longest end of the study's path that exists there
/// is used. Empty for a path that Burin never writes: one that is relative, is not in its shortest
/// form, or leads to the root of the file system or to a device.
[[nodiscard]] QStringList studyPlaces(const QString& sessionFile, const SessionSource& source);

/// Loads the volume on which a session was made and verifies it: size, affine, voxels and series
/// UID must agree. If it is not found, the images in the session are used instead
/// (LoadedVolume::notFromStudy says why). Blocks.
///
/// @param place the only place to look at; empty: studyPlaces()
/// @param series the only series to accept; empty: the session's own
/// @return errors: StudyMissing if no place is left to look at (argument 2: why the images in the
/// session cannot be used, if it has any); SessionMismatch, with the difference, if there is
/// something else; those of the loader
[[nodiscard]] Result<LoadedVolume> loadSessionStudy(const QString& sessionFile,
    const SessionSource& source, const QString& place = QString(),
    const QString& series = QString(), const Progress& progress = Progress());

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/sessionfile/records/SessionSource.h"

#include <QString>
#include <QStringList>

namespace core {

/// Where the study of a session may lie now, most likely first; only paths that exist. First where
/// it was when the session was made, then beside the session file and beside its folder, so that a
/// folder with both can be moved or copied as one: of /data/case/ct.nii and /moved/case/s.burin the
/// path's longest end that is there is tried. None for a path that no Burin writes: relative, with
/// detours, of the file system's root or the machine's devices.
[[nodiscard]] QStringList studyPlaces(const QString& sessionFile, const SessionSource& source);

/// Loads the volume that a session was made on and checks that it is the one: size, affine, voxels
/// and series UID. Where it is not found, the images that the session holds take its place
/// (LoadedVolume::notFromStudy says why). Blocks.
///
/// @param place where to look, and nowhere else; empty: studyPlaces()
/// @param series only this one; empty: the session's own
/// @return errors: StudyMissing where nothing is left to look at (argument 2: why the session's own
/// images are of no use, where it has any); SessionMismatch, with what differs, where something
/// else is there; the loader's own
[[nodiscard]] Result<LoadedVolume> loadSessionStudy(const QString& sessionFile,
    const SessionSource& source, const QString& place = QString(),
    const QString& series = QString(), const Progress& progress = Progress());

} // namespace core

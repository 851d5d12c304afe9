// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/records/SavedImages.h"
#include "core/volume/Volume.h"

#include <QString>

namespace core {

/// A session file, not under its name yet, that holds a study's images and headers and no step:
/// SessionFile::saveAs() lets a session go on in it, or StagedFile::commit() makes it one of its
/// own. Who the patient is stands in the table of references only, like where the study was.
///
/// Reads the headers of the study's files (or takes those kept of them). Blocks; one core
/// compresses 250 MB in about a second. @p progress tells pieces and may cancel.
/// Errors: FileExists (unless @p replaceExisting), FileUnwritable, Cancelled, and those of reading
/// headers.
[[nodiscard]] Result<StagedFile> stageImages(const QString& target, bool replaceExisting,
    const LoadedVolume& study, const Progress& progress = Progress());

/// The volume that a session file holds, as it was loaded from the study's files; its checksum is
/// that of the session's references. Touches neither the file nor its folder. Blocks.
/// Errors: NoImages (the session holds none), SessionDamaged with the piece that is, OutOfMemory,
/// Cancelled, and those of SessionFile::open().
[[nodiscard]] Result<LoadedVolume> loadSessionImages(
    const QString& sessionFile, const Progress& progress = Progress());

/// The images of one session file into another that holds none, as they are, every piece checked.
/// Errors: as loadSessionImages(); FileUnwritable.
[[nodiscard]] Result<void> copySessionImages(const QString& from, const QString& to);

} // namespace core

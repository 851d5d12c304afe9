// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/files/StagedFile.h"
#include "core/sessionfile/records/SavedImages.h"
#include "core/volume/Volume.h"

#include <QString>

namespace core {

/// Makes a session file, not yet under its name, that holds a study's images and headers but no
/// step. Either a session continues in it (SessionFile::saveAs()), or StagedFile::commit() makes it
/// a session of its own. The identity of the patient and the place of the study are in the table of
/// references only.
///
/// Reads the headers of the study's files, or takes those that were kept. Blocks; one core
/// compresses 250 MB in about a second. @p progress counts pieces and may cancel. Errors:
/// FileExists (unless @p replaceExisting), FileUnwritable, Cancelled, and those of reading headers.
[[nodiscard]] Result<StagedFile> stageImages(const QString& target, bool replaceExisting,
    const LoadedVolume& study, const Progress& progress = Progress());

/// The volume in a session file, as it was loaded from the study's files; its checksum is that in
/// the session's references. Changes neither the file nor its folder. Blocks. Errors: NoImages (the
/// session holds none), SessionDamaged with the damaged piece, OutOfMemory, Cancelled, and those of
/// SessionFile::open().
[[nodiscard]] Result<LoadedVolume> loadSessionImages(
    const QString& sessionFile, const Progress& progress = Progress());

/// Copies the images of one session file, as they are, into another that holds none. Every piece is
/// checked. Errors: those of loadSessionImages(); FileUnwritable.
[[nodiscard]] Result<void> copySessionImages(const QString& from, const QString& to);

} // namespace core

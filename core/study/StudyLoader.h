// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/study/StudyListing.h"

#include <QString>

namespace core {

/// Lists what @p path (a file, or a folder with all below it) holds: DICOM by content, whatever the
/// file names, and NIfTI (.nii, .nii.gz).
///
/// Reads headers only, by file on all cores. Unreadable files are part of the listing; an error is
/// returned when nothing at all could be read: FileNotFound, FolderEmpty, NoImages, the file's own
/// error if @p path is one file, or Cancelled. Blocking; call it beside the UI thread.
[[nodiscard]] Result<StudyListing> scanStudies(
    const QString& path, const Progress& progress = Progress());

/// Opens one volume with its voxels.
///
/// @param series key or SeriesInstanceUID; empty: the only volume there is. SeriesAmbiguous, with
/// one line per candidate, where more than one is left; SeriesNotFound where none is.
/// Slices that cannot be decoded are left out and named in Volume::problems; an error is returned
/// if none is left. Blocking; decodes on all cores; @p progress tells slices done and may cancel.
[[nodiscard]] Result<LoadedVolume> loadVolume(
    const QString& path, const QString& series = QString(), const Progress& progress = Progress());

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"

#include <QByteArray>
#include <QStringList>

#include <vector>

namespace core {

// Reads grey-scale pictures (PNG, TIFF) as volumes. The single pictures of a folder form one stack,
// in the natural order of their names; a TIFF with several pages is a stack of its own. Their axes
// are assumed to be those of the patient: columns to the left, rows to posterior, slices to
// superior, the first voxel at the origin.

/// The name of the format in Volume::sourceFormat.
inline constexpr const char* imageFormatName = "pictures";

/// The stacks that a set of files forms.
struct FoundStacks {
    /// Keys are set by the listing. Files: one per slice, or the one with all pages.
    std::vector<SeriesEntry> entries;
    std::vector<UnreadableFile> unreadable; ///< one for every stack that cannot be formed
    QStringList others; ///< files that are not pictures in spite of their names
};
/// Reads headers only, on all cores. A stack needs pictures of one size and kind. A file with a
/// damaged header keeps its place as an empty slice and is reported.
/// @param files those for which isImageName() holds
[[nodiscard]] FoundStacks findImageStacks(const QStringList& files, const Progress& progress);

/// The path that was opened, for an entry of a listing: the folder, or the single file.
[[nodiscard]] QString stackPath(const SeriesEntry& entry);

/// The volume with its voxels, decoded on all cores (core/fence), in the geometry of the entry.
/// Pictures that cannot be decoded are empty slices (0), listed in Volume::problems. Errors:
/// InvalidGeometry (files were changed), OutOfMemory, Cancelled; the error of the first slice if
/// none can be read.
[[nodiscard]] Result<LoadedVolume> loadImageStack(
    const SeriesEntry& entry, const Progress& progress);

/// A summary of the headers of a stack, for sessions without the files; empty if there is no stack.
/// @param path stackPath()
[[nodiscard]] QByteArray imageStackHeader(const QString& path);
/// The grid described by such a summary, in millimetres if the files state them, else in voxels.
[[nodiscard]] Result<VolumeGeometry> imageStackGeometryOf(
    const QByteArray& header, const QString& path);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"

#include <QByteArray>
#include <QStringList>

#include <vector>

namespace core {

// Pictures in grey (PNG, TIFF) as volumes: the single pictures of a folder are one stack, in the
// natural order of their names; a TIFF of several pages is a stack of its own. Their axes are taken
// for those of the patient: columns to the left, rows to posterior, slices to superior, the first
// voxel at the origin.

/// As Volume::sourceFormat has it.
inline constexpr const char* imageFormatName = "pictures";

/// The stacks that files make up.
struct FoundStacks {
    /// Keys are left to the listing. Files: per slice, or the one with all pages.
    std::vector<SeriesEntry> entries;
    std::vector<UnreadableFile> unreadable; ///< one for every stack that there cannot be
    QStringList others; ///< files that are no pictures, whatever their names say
};
/// Reads headers only, on all cores. A stack needs pictures of one size and kind; a file of a
/// folder whose header is damaged keeps its place as an empty slice, and is told of.
/// @param files of names for which isImageName()
[[nodiscard]] FoundStacks findImageStacks(const QStringList& files, const Progress& progress);

/// What was opened, by a listing's entry: the folder, or the one file.
[[nodiscard]] QString stackPath(const SeriesEntry& entry);

/// The volume with its voxels, decoded on all cores (core/fence), in the geometry of the entry.
/// Pictures that cannot be decoded are empty slices (0), named in Volume::problems.
/// InvalidGeometry (files were changed), OutOfMemory, Cancelled; the reason of the first slice
/// where there is none that can be read.
[[nodiscard]] Result<LoadedVolume> loadImageStack(
    const SeriesEntry& entry, const Progress& progress);

/// What the headers of a stack say, for sessions that must do without the files; empty where there
/// is none. @param path stackPath()
[[nodiscard]] QByteArray imageStackHeader(const QString& path);
/// The grid that such a header says, in millimetres where the files name them, else in voxels.
[[nodiscard]] Result<VolumeGeometry> imageStackGeometryOf(
    const QByteArray& header, const QString& path);

} // namespace core

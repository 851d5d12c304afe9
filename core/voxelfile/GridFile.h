// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/volume/StudyListing.h"
#include "core/voxelfile/VoxelSource.h"

#include <QByteArray>

#include <functional>

namespace core {

/// A file of one volume whose header is text (NRRD, MetaImage), of which only the header was read.
struct GridFile {
    VolumeGeometry geometry;
    std::vector<VolumeProblem> problems; ///< those that the header shows
    VoxelSource voxels;
};

/// The greatest length of a text header; long ones have many segments with tags, or a list of
/// slices.
constexpr qint64 longestTextHeader = qint64(1) << 22;

/// The beginning of a file, read part by part as far as its text header goes, or the whole file.
/// Errors: FileUnreadable, also where longestTextHeader is passed; FileTruncated: it is empty.
/// @param isRead returns whether the header has ended; receives all bytes read so far and their
/// number before the last part
[[nodiscard]] Result<QByteArray> readTextHeader(const QString& path,
    const std::function<bool(const QByteArray& bytes, qsizetype before)>& isRead);

/// Sets the geometry's size from the sides in a header, and `voxels.voxels`. Errors:
/// InvalidGeometry for sides below 1 or above 32768.
[[nodiscard]] Result<void> setGridSize(GridFile& grid, std::span<const qint64> sides);
/// Checks that the axes span a volume of finite size at a finite position. Errors: InvalidGeometry.
/// @param path, where the file, and the header's name for its axes; for the message
[[nodiscard]] Result<void> checkGridAxes(
    const VolumeGeometry& geometry, const QString& path, const Clause& where);

/// The entry of a file in a listing: its files are the header, then separate files with voxels; the
/// listing sets the key. Checks that the voxels exist; errors: those of checkVoxelFiles().
[[nodiscard]] Result<SeriesEntry> entryOf(const GridFile& grid);
/// The volume with its voxels. Errors: those of readVoxels().
[[nodiscard]] Result<LoadedVolume> loadGridFile(const GridFile& grid, const SeriesEntry& entry,
    const QString& format, const Progress& progress);

} // namespace core

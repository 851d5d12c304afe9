// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/voxelfile/VoxelSource.h"

#include <QByteArray>

namespace core {

/// A file of one volume whose header is text (NRRD, MetaImage), read as far as that header.
struct GridFile {
    VolumeGeometry geometry;
    std::vector<VolumeProblem> problems; ///< those that the header shows
    VoxelSource voxels;
};

/// No header in words is longer: many segments with their tags, or a list of slices.
constexpr qint64 longestTextHeader = qint64(1) << 22;

/// Sets the geometry's size from the sides that a header names, and `voxels.voxels`.
/// InvalidGeometry for sides below 1 or beyond 32768.
[[nodiscard]] Result<void> setGridSize(GridFile& grid, std::span<const qint64> sides);
/// The axes span a volume of finite size, at a finite place; InvalidGeometry if not.
/// @param path, where what the header calls its axes: for the sentence
[[nodiscard]] Result<void> checkGridAxes(
    const VolumeGeometry& geometry, const QString& path, const QString& where);

/// What a listing shows of it: of files the header, then those that hold its voxels elsewhere; the
/// key is left to the listing. Checks that the voxels are there: errors as of checkVoxelFiles().
[[nodiscard]] Result<SeriesEntry> entryOf(const GridFile& grid);
/// The volume with its voxels. Errors as of readVoxels().
[[nodiscard]] Result<LoadedVolume> loadGridFile(const GridFile& grid, const SeriesEntry& entry,
    const QString& format, const Progress& progress);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/voxelfile/GridFile.h"

#include <QByteArray>

namespace core {

/// By name, as the format asks for it: .mha and .mhd.
[[nodiscard]] bool isMetaImageName(const QString& path);

/// Geometry, facts and the place of the voxels, from a file's header. Errors as of
/// readMetaImageEntry().
[[nodiscard]] Result<GridFile> readMetaImage(const QString& path);

/// What a listing shows of a file, from its header: files are the header and
/// those that hold its voxels elsewhere. Its world is LPS in millimetres, as
/// ITK reads and writes it; the index order is kept; a centre of rotation is
/// left out of account. UnsupportedFormat for more than one volume, several
/// channels and types that are no numbers.
[[nodiscard]] Result<SeriesEntry> readMetaImageEntry(const QString& path);

/// The volume with its voxels. FileTruncated, FileUnreadable, OutOfMemory.
[[nodiscard]] Result<LoadedVolume> loadMetaImage(
    const SeriesEntry& entry, const Progress& progress);

/// The header of a file as it lies there; empty if it cannot be read.
[[nodiscard]] QByteArray metaImageHeaderBytes(const QString& path);
/// The grid that such a header says; its file may be missing.
[[nodiscard]] Result<VolumeGeometry> metaImageGeometryOf(
    const QByteArray& header, const QString& path);

} // namespace core

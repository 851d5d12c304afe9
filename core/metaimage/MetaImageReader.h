// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/voxelfile/GridFile.h"

#include <QByteArray>

namespace core {

/// Whether a file is a MetaImage by its name, as the format requires: .mha or .mhd.
[[nodiscard]] bool isMetaImageName(const QString& path);

/// Reads geometry, properties and the position of the voxels from a file's header. Errors: those of
/// readMetaImageEntry().
[[nodiscard]] Result<GridFile> readMetaImage(const QString& path);

/// The entry of a file in a listing, from its header; its files are the header and separate files
/// with voxels. The world is LPS in millimetres, as ITK reads and writes it. The index order is
/// kept; a centre of rotation is ignored. UnsupportedFormat for more than one volume, several
/// channels, and types that are not numbers.
[[nodiscard]] Result<SeriesEntry> readMetaImageEntry(const QString& path);

/// The volume with its voxels. FileTruncated, FileUnreadable, OutOfMemory.
[[nodiscard]] Result<LoadedVolume> loadMetaImage(
    const SeriesEntry& entry, const Progress& progress);

/// The bytes of a file's header; empty if it cannot be read.
[[nodiscard]] QByteArray metaImageHeaderBytes(const QString& path);
/// The grid of such a header; the file itself may be missing.
[[nodiscard]] Result<VolumeGeometry> metaImageGeometryOf(
    const QByteArray& header, const QString& path);

} // namespace core

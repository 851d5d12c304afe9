// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/voxelfile/GridFile.h"

#include <map>

namespace core {

/// Whether a file is NRRD by its name, as the format requires: .nrrd or .nhdr.
[[nodiscard]] bool isNrrdName(const QString& path);

/// Reads geometry, properties and the position of the voxels from a file's header. Patient spaces
/// become LPS millimetres; a file without one is placed by its spacings and axis minima, with a
/// caution. The file's index order is kept. UnsupportedFormat for more than one volume, vectors,
/// bzip2 and scanner space.
[[nodiscard]] Result<GridFile> readNrrd(const QString& path);
/// A file with several numbers per voxel, as 3D Slicer writes overlapping segments: the grid of one
/// layer, while `voxels` describes all of them, the numbers of a voxel one after the other.
struct NrrdLayers {
    GridFile grid;
    int layers = 1;
    std::map<QByteArray, QByteArray> keyValues; ///< of the header
};
/// The same as readNrrd(), but a first axis that is not spatial is allowed.
[[nodiscard]] Result<NrrdLayers> readNrrdLayers(const QString& path);

/// The entry of a file in a listing; its files are the header and separate files with voxels.
/// Checks that they exist; FileTruncated if they are too short.
[[nodiscard]] Result<SeriesEntry> readNrrdEntry(const QString& path);
/// The grid of a header; the file itself may be missing.
/// @param header the bytes that nrrdHeaderBytes() returned
[[nodiscard]] Result<VolumeGeometry> nrrdGeometryOf(const QByteArray& header, const QString& path);

/// The volume with its voxels. FileTruncated, FileUnreadable, OutOfMemory.
[[nodiscard]] Result<LoadedVolume> loadNrrd(const SeriesEntry& entry, const Progress& progress);

/// The bytes of a file's header; empty if it cannot be read.
[[nodiscard]] QByteArray nrrdHeaderBytes(const QString& path);

} // namespace core

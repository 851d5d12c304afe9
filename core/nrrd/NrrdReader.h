// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/voxelfile/GridFile.h"

#include <map>

namespace core {

/// By name, as the format asks for it: .nrrd and .nhdr.
[[nodiscard]] bool isNrrdName(const QString& path);

/// Geometry, facts and the place of the voxels, from a file's header. Spaces of the patient become
/// LPS millimetres; a file without one lies as its spacings and axis minima say, with a caution.
/// The file's index order is kept. UnsupportedFormat for more than one volume, vectors, bzip2 and
/// the scanner's own space.
[[nodiscard]] Result<GridFile> readNrrd(const QString& path);
/// A file with several numbers a voxel, as 3D Slicer writes segments that overlap: the grid of one,
/// while `voxels` tells of all, those of a voxel one behind the other.
struct NrrdLayers {
    GridFile grid;
    int layers = 1;
    std::map<QByteArray, QByteArray> keyValues; ///< of the header
};
/// As readNrrd(), with a first axis that is none of space, or without.
[[nodiscard]] Result<NrrdLayers> readNrrdLayers(const QString& path);

/// What a listing shows of it: files are the header and those that hold its voxels elsewhere.
/// Whether they are there is checked; FileTruncated where they are too short.
[[nodiscard]] Result<SeriesEntry> readNrrdEntry(const QString& path);
/// The grid that a header says, its file may be missing.
/// @param header the bytes that nrrdHeaderBytes() returned
[[nodiscard]] Result<VolumeGeometry> nrrdGeometryOf(const QByteArray& header, const QString& path);

/// The volume with its voxels. FileTruncated, FileUnreadable, OutOfMemory.
[[nodiscard]] Result<LoadedVolume> loadNrrd(const SeriesEntry& entry, const Progress& progress);

/// The header of a file as it lies there; empty if it cannot be read.
[[nodiscard]] QByteArray nrrdHeaderBytes(const QString& path);

} // namespace core

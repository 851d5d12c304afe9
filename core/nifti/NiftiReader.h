// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/voxelfile/StoredScalars.h"

#include <optional>
#include <vector>

namespace core {

/// Whether a file is NIfTI by its name, as the format requires: .nii or .nii.gz.
[[nodiscard]] bool isNiftiName(const QString& path);
/// The same, or the header of a volume whose voxels are in an .img beside it: an .hdr that begins
/// like one. Cost: opens an .hdr.
[[nodiscard]] bool isNiftiFile(const QString& path);

/// The entry of a file in a listing, from its header; the listing sets the key. The geometry is
/// that of sform, else of qform, else of the pixel sizes with a caution; RAS is converted to LPS,
/// in millimetres. The file's index order is kept even if it is left-handed, so that a mask fits
/// its grid. Files: the one with the header, and the one with the voxels if it is another.
/// Volumes along the fourth axis are points in time, without labels. UnsupportedFormat for axes
/// beyond that, colour or complex values, and for an Analyze header; FileUnreadable if the voxels
/// are not beside it.
[[nodiscard]] Result<SeriesEntry> readNiftiEntry(const QString& path);

/// The numbers of a file, in the machine's byte order, and how they become values.
struct NiftiNumbers {
    std::vector<char> bytes;
    ScalarType type = ScalarType::Int16;
    double slope = 1.0;
    double intercept = 0.0;
    std::optional<WindowLevel> window{};
};
/// Errors: FileTruncated, OutOfMemory.
/// @param time 0-based
[[nodiscard]] Result<NiftiNumbers> readNiftiNumbers(const SeriesEntry& entry, int time = 0);

/// The volume at a point in time (0-based) with its voxels; scl_slope and scl_inter applied.
/// FileTruncated, OutOfMemory.
[[nodiscard]] Result<LoadedVolume> loadNifti(
    const SeriesEntry& entry, int time, const Progress& progress);

/// The 348 bytes of a file's header in the machine's byte order; empty if it cannot be read.
[[nodiscard]] QByteArray niftiHeaderBytes(const QString& path);

} // namespace core

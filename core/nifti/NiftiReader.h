// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/StudyListing.h"
#include "core/voxelfile/StoredScalars.h"

#include <optional>
#include <vector>

namespace core {

/// By name, as the format asks for it: .nii and .nii.gz.
[[nodiscard]] bool isNiftiName(const QString& path);

/// Geometry and facts of a file, from its header; the key is left to the listing: sform, else
/// qform, else pixel sizes with a caution; RAS turned into LPS, millimetres. The file's index order
/// is kept, even where it is left-handed, so that a mask lands on its grid. UnsupportedFormat for
/// more than one volume, colour or complex values.
[[nodiscard]] Result<SeriesEntry> readNiftiEntry(const QString& path);

/// The numbers of a file, in the machine's byte order, and what makes values of them.
struct NiftiNumbers {
    std::vector<char> bytes;
    ScalarType type = ScalarType::Int16;
    double slope = 1.0;
    double intercept = 0.0;
    std::optional<WindowLevel> window{};
};
/// FileTruncated, OutOfMemory.
[[nodiscard]] Result<NiftiNumbers> readNiftiNumbers(const SeriesEntry& entry);

/// The volume with its voxels; scl_slope and scl_inter applied. FileTruncated, OutOfMemory.
[[nodiscard]] Result<LoadedVolume> loadNifti(const SeriesEntry& entry, const Progress& progress);

/// The 348 bytes of a file's header, in this machine's byte order; empty if it cannot be read.
[[nodiscard]] QByteArray niftiHeaderBytes(const QString& path);

} // namespace core

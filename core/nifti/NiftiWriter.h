// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/volume/VolumeGeometry.h"

#include <QString>

#include <cstdint>
#include <span>
#include <variant>

namespace core {

/// Voxels to be written to a NIfTI file, x fastest: bytes (uint8, with intent "label" by default)
/// or modality values (int16, float32).
using NiftiVoxels = std::variant<std::span<const std::uint8_t>, std::span<const std::int16_t>,
    std::span<const float>>;

struct NiftiImage {
    /// Size and affine; `slicePositions` cannot be stored in NIfTI and are ignored.
    VolumeGeometry geometry;
    NiftiVoxels voxels;
    QString description; ///< shortened to 79 bytes
    bool labels = true; ///< for bytes: whether they are labels
};

/// What a reader must know about the written file.
struct NiftiWritten {
    /// False: qform_code is 0, because a quaternion cannot represent this grid (it is sheared, or
    /// closer to a half turn than 32-bit floats resolve). The sform is always correct.
    bool qform = true;
};

/// Writes NIfTI-1 (nifti1.h, R. Cox 2003) as one file, gzip-compressed if the name ends in ".gz".
/// The grid is the given one in RAS mm (x and y of LPS negated): always as sform, and as qform if
/// that agrees.
///
/// The file appears under its name only when it is complete. Any thread.
/// Errors: FileExists (unless @p replaceExisting), FileUnwritable, UnsupportedFormat (a side over
/// 32767, or the number of voxels does not match the size).
Result<NiftiWritten> writeNifti(
    const QString& file, const NiftiImage& image, bool replaceExisting = false);

/// The same without staging, for callers that stage the file themselves.
Result<NiftiWritten> writeNiftiAt(const QString& path, const NiftiImage& image);

} // namespace core

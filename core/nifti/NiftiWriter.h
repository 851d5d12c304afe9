// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/volume/VolumeGeometry.h"

#include <QString>

#include <cstdint>
#include <span>
#include <variant>

namespace core {

/// Voxels on their way into a NIfTI file, x fastest: bytes (uint8, intent "label" unless something
/// else is said) or modality values (int16, float32).
using NiftiVoxels = std::variant<std::span<const std::uint8_t>, std::span<const std::int16_t>,
    std::span<const float>>;

struct NiftiImage {
    /// Size and affine; `slicePositions` have no place in NIfTI and are not looked at.
    VolumeGeometry geometry;
    NiftiVoxels voxels;
    QString description; ///< at most 79 bytes of it are kept
    bool labels = true; ///< of bytes: whether they are labels
};

/// What a reader must know about the file that was written.
struct NiftiWritten {
    /// False: qform_code is 0, because a quaternion cannot hold this grid (sheared, or closer to a
    /// half turn than 32-bit floats resolve); the sform holds it in any case.
    bool qform = true;
};

/// Writes NIfTI-1 (nifti1.h, R. Cox 2003), one file, gzip-compressed if the name ends in ".gz". The
/// grid is the given one, in RAS mm (x and y of LPS negated): sform always, qform where it agrees.
///
/// The file appears under its name only when it is whole. Any thread.
/// Errors: FileExists (unless @p replaceExisting), FileUnwritable, UnsupportedFormat (a side over
/// 32767, or not as many voxels as the size says).
Result<NiftiWritten> writeNifti(
    const QString& file, const NiftiImage& image, bool replaceExisting = false);

/// The same without the staging: for callers that stage the file themselves.
Result<NiftiWritten> writeNiftiAt(const QString& path, const NiftiImage& image);

} // namespace core

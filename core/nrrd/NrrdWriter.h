// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/volume/VolumeGeometry.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace core {

/// Bytes on their way into an NRRD file, x fastest, and what is said about them.
struct NrrdImage {
    /// Size and affine; `slicePositions` have no place in NRRD and are not looked at.
    VolumeGeometry geometry;
    std::span<const std::uint8_t> voxels;
    /// In UTF-8, as they are meant: backslashes and line ends are escaped here. No key holds ":".
    std::vector<std::pair<QByteArray, QByteArray>> keyValues;
};

/// Writes NRRD (teem.sourceforge.net/nrrd/format.html, version 4), one file, its voxels packed with
/// gzip: space left-posterior-superior, directions and origin to the last bit of the geometry. For
/// callers that stage the file themselves. Any thread.
/// Errors: FileUnwritable, UnsupportedFormat (not as many voxels as the size says).
Result<void> writeNrrdAt(const QString& path, const NrrdImage& image);

} // namespace core

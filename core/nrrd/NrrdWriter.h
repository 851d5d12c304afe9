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

/// Bytes to be written to an NRRD file, x fastest, with their description.
struct NrrdImage {
    /// Size and affine; `slicePositions` cannot be stored in NRRD and are ignored.
    VolumeGeometry geometry;
    std::span<const std::uint8_t> voxels;
    /// In UTF-8, unescaped: backslashes and line ends are escaped by the writer. Keys must not
    /// contain ":".
    std::vector<std::pair<QByteArray, QByteArray>> keyValues;
    int layers = 1; ///< numbers of each voxel, which stand one after another in `voxels`
};

/// Writes NRRD (teem.sourceforge.net/nrrd/format.html, version 4) as one file with voxels
/// compressed by gzip. Space is left-posterior-superior; directions and origin have the full
/// precision of the geometry. For callers that stage the file themselves. Any thread. Errors:
/// FileUnwritable, UnsupportedFormat (the number of bytes does not match the size).
Result<void> writeNrrdAt(const QString& path, const NrrdImage& image);

} // namespace core

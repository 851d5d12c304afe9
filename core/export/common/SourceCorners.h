// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <array>

namespace core {

/// The centres of a grid's eight outermost voxels, LPS mm.
using GridCorners = std::array<glm::dvec3, 8>;

[[nodiscard]] GridCorners cornersOf(const glm::dmat4& affine, const glm::ivec3& size);
/// The greatest distance between corresponding corners.
[[nodiscard]] double farthest(const GridCorners& a, const GridCorners& b);

/// The corners according to the volume's source files, which are read from the disk now, or to the
/// headers that its session keeps.
/// @param file the export that is checked, for the message
/// Errors: ExportMismatch, and those of reading.
Result<GridCorners> sourceCorners(
    const QString& file, const Volume& volume, const Progress& progress);

} // namespace core

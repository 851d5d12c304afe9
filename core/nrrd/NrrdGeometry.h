// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nrrd/NrrdHeader.h"
#include "core/voxelfile/GridFile.h"

namespace core {

/// Sets size and affine of a grid from an NRRD header, and adds what a user must know. Errors:
/// FileUnreadable, UnsupportedFormat, InvalidGeometry.
[[nodiscard]] Result<void> setNrrdGeometry(GridFile& grid, const NrrdHeader& header);

/// Integers separated by blanks; none if one of them is not an integer.
[[nodiscard]] std::optional<std::vector<qint64>> wholeNumbers(const QByteArray& text);

} // namespace core

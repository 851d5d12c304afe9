// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nrrd/NrrdHeader.h"
#include "core/voxelfile/GridFile.h"

namespace core {

/// Sets size and affine of a grid as an NRRD header says them, with what a reader must know.
/// FileUnreadable, UnsupportedFormat, InvalidGeometry.
[[nodiscard]] Result<void> setNrrdGeometry(GridFile& grid, const NrrdHeader& header);

/// Whole numbers apart by blanks; none if one of them is not.
[[nodiscard]] std::optional<std::vector<qint64>> wholeNumbers(const QByteArray& text);

} // namespace core

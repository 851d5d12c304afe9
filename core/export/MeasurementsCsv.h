// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/measure/region/Measured.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace core {

// Exports measurements as a table: CSV by RFC 4180, UTF-8, a line of column names, then one line
// per measurement. Cells without a number are empty. Sizes are in the unit that their line states,
// "mm" or "voxels"; points are at their true places (truePlace()), LPS mm, "x y z; x y z".

[[nodiscard]] QByteArray measurementsCsv(const std::vector<Measured>& all, const Volume& volume);

/// Writes the table, reads it back from the disk and compares every number. The file appears under
/// its name only after that. Blocks. Errors: FileExists, FileUnwritable, FileUnreadable,
/// ExportMismatch.
/// @param force replaces an existing file of that name
[[nodiscard]] Result<void> exportMeasurements(
    const std::vector<Measured>& all, const Volume& volume, const QString& file, bool force);

} // namespace core

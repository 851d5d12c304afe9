// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/measure/region/Measured.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace core {

// What was measured, as a table: RFC 4180, UTF-8, a line of names, then one line per measurement.
// Cells without a number are empty. Sizes are in the unit of their line, "mm" or "voxels"; points
// are at their true places, LPS mm, "x y z; x y z".

[[nodiscard]] QByteArray measurementsCsv(const std::vector<Measured>& all, const Volume& volume);

/// Writes the table, reads it again from the disk and compares every number. The file appears
/// under its name only after that. Errors: FileExists, FileUnwritable, FileUnreadable,
/// ExportMismatch.
/// @param force replaces a file of that name
[[nodiscard]] Result<void> exportMeasurements(
    const std::vector<Measured>& all, const Volume& volume, const QString& file, bool force);

} // namespace core

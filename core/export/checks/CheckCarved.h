// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <functional>

namespace core {

/// What a voxel must be, by its place in the array.
using ExpectedValue = std::function<double(std::size_t)>;

/// Opens a NIfTI file with the NIfTI C library: the grid is the volume's, every voxel as expected,
/// in the precision that the file holds.
/// Errors: ExportMismatch (argument 0 the file, 1 what does not agree), FileUnreadable.
Result<QStringList> checkNiftiValues(
    const QString& file, const Volume& volume, const ExpectedValue& expected);

/// Opens a folder as any study is opened: one series, new, of the same study and frame of
/// reference, derived, on the same grid, every voxel as expected.
/// @param tolerance of values, where those of the volume are rounded
/// Errors: as above, and those of opening a study.
Result<QStringList> checkCarvedSeries(const QString& folder, const Volume& volume,
    const ExpectedValue& expected, double tolerance, const Progress& progress);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <functional>

namespace core {

/// The expected value of a voxel, by its index in the array.
using ExpectedValue = std::function<double(std::size_t)>;

/// Opens a NIfTI file with the NIfTI C library and checks that the grid is the volume's and that
/// every voxel is as expected, within the precision of the file. Errors: ExportMismatch (argument 0
/// the file, 1 the difference), FileUnreadable.
Result<ReportLines> checkNiftiValues(
    const QString& file, const Volume& volume, const ExpectedValue& expected);

/// Opens a folder like any study and checks that it is one new, derived series of the same study
/// and frame of reference on the same grid, and that every voxel is as expected.
/// @param tolerance of values, if those of the volume are rounded
/// Errors: as above, and those of opening a study.
Result<ReportLines> checkCarvedSeries(const QString& folder, const Volume& volume,
    const ExpectedValue& expected, double tolerance, const Progress& progress);

} // namespace core

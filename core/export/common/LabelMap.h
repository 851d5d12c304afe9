// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/CheckExport.h"
#include "core/export/common/MaskSelection.h"
#include "core/export/common/SourceCorners.h"

namespace core {

/// The selected segments in one map on the volume's grid, each by its label.
struct LabelMap {
    std::vector<std::uint8_t> labels; ///< x fastest
    QStringList names; ///< "3 Skull", in the order of the segments
};

/// "the source's grid", or that of its repair.
[[nodiscard]] QString gridName(const Volume& volume);

/// For formats that have one number a voxel and one step for all slices. What slices that lie
/// unevenly mean for the reader goes into the report.
/// @param format for the sentences
/// Errors: UnsupportedFormat (segments that overlap or share a label, slices too uneven).
Result<LabelMap> labelMapOf(const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const QString& format, ExportReport& report);

/// Where the source files themselves have the corners of such a map, and how far it may be off.
struct LabelMapPlace {
    GridCorners corners{};
    double toleranceMm = 0.0;
};

/// Errors: those of sourceCorners(), and ExportMismatch where the sources do not lie where the
/// volume has them.
Result<LabelMapPlace> labelMapPlace(
    const QString& file, const Volume& volume, const Progress& progress);

/// How many voxels of a map are not as they should have been written.
[[nodiscard]] std::size_t wrongVoxels(
    std::span<const std::uint8_t> voxels, const ExportExpectation& expected);

} // namespace core

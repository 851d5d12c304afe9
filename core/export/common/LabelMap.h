// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/CheckExport.h"
#include "core/export/common/MaskSelection.h"
#include "core/export/common/SourceCorners.h"

namespace core {

/// The selected segments in one map on the volume's grid, each by its label.
struct LabelMap {
    std::vector<std::uint8_t> labels; ///< x fastest; of several layers, a voxel's one by one
    QStringList names; ///< "3 Skull", in the order of the segments
    std::vector<int> layerOf; ///< of each segment, from 0
    int layers = 1;
};

/// "the source's grid", or the name of the repaired grid.
[[nodiscard]] ReportSentence gridName(const Volume& volume);

/// Makes the map for formats with one number per voxel and one distance for all slices. If slices
/// are uneven, the report says what that means for the reader.
/// @param format its name, for the sentences
/// Errors: UnsupportedFormat (segments that overlap or share a label, slices too uneven).
Result<LabelMap> labelMapOf(const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const QString& format, ExportReport& report);

/// The same for a format with several numbers per voxel, so that segments may overlap: one layer if
/// none do, else one for each label plane that holds a segment, in their order.
/// Errors: UnsupportedFormat (segments that share a label, slices too uneven).
Result<LabelMap> labelLayersOf(const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const QString& format, ExportReport& report);

/// The corners of such a map according to the source files, with the tolerance.
struct LabelMapPlace {
    GridCorners corners{};
    double toleranceMm = 0.0;
};

/// Errors: those of sourceCorners(), and ExportMismatch if the sources are not where the volume has
/// them.
Result<LabelMapPlace> labelMapPlace(
    const QString& file, const Volume& volume, const Progress& progress);

/// The number of voxels of a map that are not as they should have been written.
[[nodiscard]] std::size_t wrongVoxels(
    std::span<const std::uint8_t> voxels, const ExportExpectation& expected);
/// The same of a map of layers, in any of them.
/// @param layerOf of each segment
[[nodiscard]] std::size_t wrongVoxels(std::span<const std::uint8_t> voxels,
    const ExportExpectation& expected, const std::vector<int>& layerOf, int layers);

} // namespace core

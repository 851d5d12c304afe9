// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/CheckExport.h"
#include "core/export/common/MaskSelection.h"
#include "core/export/common/SourceCorners.h"

namespace core {

/// The selected segments in one map on the volume's grid, each by its label.
struct LabelMap {
    /// One number for each voxel, x fastest; with several layers, all numbers of a voxel one after
    /// another.
    std::vector<std::uint8_t> labels;
    QStringList names; ///< "3 Skull", in the order of the segments
    std::vector<int> layerOf; ///< for each segment, its layer, from 0
    int layers = 1;
};

/// "the source's grid", or the name of the repaired grid.
[[nodiscard]] ReportSentence gridName(const Volume& volume);

/// The reason why a volume cannot be written to a file with one step for all slices: they are so
/// uneven that some would be displaced by more than a tenth of the step. Empty if it can be; if
/// slices are displaced at all, a caution that says how far is added.
/// @param format its name, for the sentences
/// @param instead what keeps the slices in their places, as a clause
[[nodiscard]] Clause oneStepObstacle(
    const Volume& volume, const QString& format, const Clause& instead, ReportLines& cautions);

/// Makes the map for formats with one number per voxel and one distance for all slices. If slices
/// are uneven, the report says what that means for the reader.
/// @param format its name, for the sentences
/// Errors: UnsupportedFormat (segments that overlap or share a label, slices too uneven).
Result<LabelMap> labelMapOf(const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const QString& format, ExportReport& report);

/// The same for formats with several numbers per voxel, so that segments may overlap: one layer if
/// none overlap, otherwise one for each label plane that contains a segment, in the order of the
/// planes.
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
/// The same for a map with several layers; a voxel counts if any of them is wrong.
/// @param layerOf the layer of each segment
[[nodiscard]] std::size_t wrongVoxels(std::span<const std::uint8_t> voxels,
    const ExportExpectation& expected, const std::vector<int>& layerOf, int layers);

} // namespace core

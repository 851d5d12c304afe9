// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"
#include "tests/support/series/SmallSeries.h"

#include <QString>
#include <QTemporaryDir>

#include <cstdint>
#include <vector>

namespace test {

/// A position and orientation of a series in space.
struct SeriesPlacement {
    const char* name;
    SmallSeries series; ///< 11 × 7 × 6 voxels; "one slice" has 11 × 7
    bool tilted = false; ///< its slices are sheared
    bool even = true; ///< its slices are equally far apart
};

/// The placements axial, prone, flipped, coronal, sagittal, oblique, tilted, oblique and tilted, of
/// one slice, and with one slice too far away. Every mask format has to preserve all of them.
[[nodiscard]] std::vector<SeriesPlacement> seriesPlacements();
/// Adds a test row for each placement, with the column "placement".
/// @param uneven also with uneven slices, which a format with a single affine refuses
void addPlacementRows(bool uneven = true);
[[nodiscard]] SeriesPlacement placementOf(const QString& name);

/// The SHA-256 of the mask of one label, one byte per voxel.
[[nodiscard]] QString sha256OfLabel(const std::vector<std::uint8_t>& labels, int label);

/// A series on disk, labels on its grid, and a folder for exports.
struct LabelledSeries {
    using Write = core::Volume (SmallSeries::*)(const QString& folder) const;
    LabelledSeries(const SmallSeries& series, std::vector<std::uint8_t> gridLabels,
        Write write = &SmallSeries::write);

    /// The number of files beside the series, including hidden ones.
    [[nodiscard]] qsizetype fileCount() const;
    [[nodiscard]] QString sha256Of(int label) const { return sha256OfLabel(labels, label); }

    QTemporaryDir folder;
    QString images = folder.filePath(QStringLiteral("images"));
    core::Volume volume;
    std::vector<std::uint8_t> labels;
    std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
};

} // namespace test

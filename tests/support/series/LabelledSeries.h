// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"
#include "tests/support/series/SmallSeries.h"

#include <QString>
#include <QTemporaryDir>

#include <cstdint>
#include <vector>

namespace test {

/// One way in which a series can lie in space.
struct SeriesPlacement {
    const char* name;
    SmallSeries series; ///< 11 × 7 × 6 voxels; of "one slice" 11 × 7
    bool tilted = false; ///< its slices are sheared
    bool even = true; ///< its slices are equally far apart
};

/// Axial, prone, flipped, coronal, sagittal, oblique, tilted, oblique and tilted, of one slice, and
/// with a slice too far away: what every format of masks has to bring home.
[[nodiscard]] std::vector<SeriesPlacement> seriesPlacements();
/// A row for each of them, with the column "placement". @param uneven too: a format that knows one
/// affine for a volume refuses such slices
void addPlacementRows(bool uneven = true);
[[nodiscard]] SeriesPlacement placementOf(const QString& name);

/// Of the mask of one label, a byte a voxel.
[[nodiscard]] QString sha256OfLabel(const std::vector<std::uint8_t>& labels, int label);

/// A series on disk, labels on its grid, and room beside it for what is exported.
struct LabelledSeries {
    using Write = core::Volume (SmallSeries::*)(const QString& folder) const;
    LabelledSeries(const SmallSeries& series, std::vector<std::uint8_t> gridLabels,
        Write write = &SmallSeries::write);

    /// Files beside the series, hidden ones too.
    [[nodiscard]] qsizetype fileCount() const;
    [[nodiscard]] QString sha256Of(int label) const { return sha256OfLabel(labels, label); }

    QTemporaryDir folder;
    QString images = folder.filePath(QStringLiteral("images"));
    core::Volume volume;
    std::vector<std::uint8_t> labels;
    std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
};

} // namespace test

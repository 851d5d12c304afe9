// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/VolumeGeometry.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace core {

/// The built-in demonstration study as voxels: HeadPhantom as it would look on a scan.
struct DemoStudy {
    VolumeGeometry geometry;
    std::vector<std::int16_t> hounsfield; ///< −1024 … 3071, x fastest
    std::vector<std::uint8_t> parts; ///< HeadPart of every voxel
};

/// Makes 256 × 256 × 200 voxels of 0.9 × 0.9 × 1 mm with the noise of a scanner. The voxels are the
/// same on every call, whatever the number of cores. Takes a few seconds. Any thread.
/// Errors: Cancelled.
Result<DemoStudy> makeDemoStudy(const Progress& progress);

/// Writes @p study into @p folder as a DICOM CT series with fixed identifiers ("CT0001.dcm" …),
/// together with the ground truth: "labels.nii.gz" on the same grid, and "labels.txt" with one line
/// "value name" per part.
///
/// The folder appears complete or not at all.
/// Errors: FileUnwritable, also if there is anything but an empty folder of that name.
Result<void> writeDemoStudy(const QString& folder, const DemoStudy& study);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/VolumeGeometry.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace core {

/// The built-in demonstration study as voxels: HeadPhantom as a scanner would see it.
struct DemoStudy {
    VolumeGeometry geometry;
    std::vector<std::int16_t> hounsfield; ///< −1024 … 3071, x fastest
    std::vector<std::uint8_t> parts; ///< HeadPart of every voxel
};

/// 256 × 256 × 200 voxels of 0.9 × 0.9 × 1 mm, with a scanner's noise. The same voxels on every
/// call, whatever the number of cores; a few seconds. Any thread.
/// Errors: Cancelled.
Result<DemoStudy> makeDemoStudy(const Progress& progress);

/// Writes @p study into @p folder as a DICOM CT series of fixed identifiers ("CT0001.dcm" …), with
/// the truth beside it: "labels.nii.gz" on the same grid and "labels.txt", a line "value name"
/// each.
///
/// The folder appears whole or not at all.
/// Errors: FileUnwritable, also if there is anything but an empty folder of that name.
Result<void> writeDemoStudy(const QString& folder, const DemoStudy& study);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/repair/SeriesRepair.h"
#include "core/volume/Volume.h"

namespace core {

/// Repairs a volume as it was loaded: all of @p repair but its duplicates, which the caller chose
/// among before. Volume::repair names the whole of it, problems say by which word they were
/// repaired, and those that are so need no caution any more.
///
/// A voxel is the mean of the source's voxels around it, at most eight, weighted by integers
/// (RepairLattice.h: places in 1/65536; products of three shares, 48 bits; the sum and a half,
/// without its last 48 bits). Where one of them lies outside the images, or holds padding, the one
/// that weighs most is taken as it is. Where that is outside, too: padding if the source has any
/// that its codes can say, else the least value. A slice at a whole place keeps its very values.
///
/// Errors: InvalidField ("repair"; the reason), OutOfMemory, Cancelled.
[[nodiscard]] Result<LoadedVolume> repairVolume(
    LoadedVolume loaded, const SeriesRepair& repair, const Progress& progress = Progress());

} // namespace core

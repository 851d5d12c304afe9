// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/repair/SeriesRepair.h"
#include "core/volume/Volume.h"

namespace core {

/// Repairs a loaded volume: does everything of @p repair except for duplicates, among which the
/// caller has already chosen. Volume::repair receives the whole repair; problems record which part
/// repaired them, and these no longer need a caution.
///
/// A voxel is the mean of the (at most eight) source voxels around it, weighted by integers
/// (RepairLattice.h: positions in 1/65536; products of three shares have 48 bits; half is added to
/// the sum, and the last 48 bits are dropped). If one of them is outside the images or is padding,
/// the one with the greatest weight is taken unchanged. If that one is outside, the voxel is
/// padding if the source has any that its codes can represent, else the minimum. A slice at a whole
/// position keeps its exact values.
///
/// Errors: InvalidField ("repair"; the reason), OutOfMemory, Cancelled.
[[nodiscard]] Result<LoadedVolume> repairVolume(
    LoadedVolume loaded, const SeriesRepair& repair, const Progress& progress = Progress());

/// The part of Volume::repair that actually changed a loaded volume, in the same form. (A repair
/// may also request what the series does not need, such as `gap=fill` where no slice is missing.)
/// Empty if all slices are where they were. For sentences about what was done; the name of a volume
/// contains its whole repair.
[[nodiscard]] QString repairMade(const Volume& volume);

} // namespace core

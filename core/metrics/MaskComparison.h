// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"

#include <optional>

namespace core {

/// How far the surfaces of two masks lie apart, mm. A mask's surface is the centres of those of its
/// voxels that have one of their six neighbours outside it, or beyond the volume; a distance is
/// that of a surface voxel from the nearest one of the other mask.
struct SurfaceDistances {
    /// The greater one of both ways' 95th percentiles (straight between ranks, as NumPy's).
    double hausdorff95Mm = 0.0;
    double hausdorffMm = 0.0; ///< the greatest of both ways
    double meanMm = 0.0; ///< of all surface voxels of both (average symmetric surface distance)
    bool operator==(const SurfaceDistances&) const = default;
};

/// A mask against the one that is held for the truth.
struct MaskComparison {
    std::uint64_t voxels = 0; ///< of the mask
    std::uint64_t referenceVoxels = 0;
    std::uint64_t sharedVoxels = 0;
    /// Voxels in which they differ, divided by those of the reference (rVE; seed B, section 7.3).
    /// None where the reference is empty and the mask is not; 0 where both are.
    std::optional<double> relativeVolumeError;
    /// 2 · shared / (sum of both); 1 where both are empty.
    double dice = 1.0;
    /// None where one of them is empty; all 0 where both are.
    std::optional<SurfaceDistances> distances;
};

/// Compares two masks on one grid, uneven slices and tilted ones included.
/// Cost: a search in a tree for each voxel of both surfaces, on all cores. Any thread.
/// Errors: Cancelled.
[[nodiscard]] Result<MaskComparison> compareMasks(const VoxelRuns& mask, const VoxelRuns& reference,
    const VolumeGeometry& geometry, const Progress& progress);

} // namespace core

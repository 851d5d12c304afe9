// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"

#include <optional>

namespace core {

/// Distances between the surfaces of two masks, mm. The surface of a mask consists of the centres
/// of those of its voxels that have one of their six neighbours outside the mask or outside the
/// volume; a distance is that of a surface voxel to the nearest one of the other mask.
struct SurfaceDistances {
    /// The greater of the 95th percentiles of both directions (linear between ranks, as in NumPy).
    double hausdorff95Mm = 0.0;
    double hausdorffMm = 0.0; ///< the greatest distance in either direction
    double meanMm = 0.0; ///< over all surface voxels of both (average symmetric surface distance)
    bool operator==(const SurfaceDistances&) const = default;
};

/// A mask compared with a reference.
struct MaskComparison {
    std::uint64_t voxels = 0; ///< of the mask
    std::uint64_t referenceVoxels = 0;
    std::uint64_t sharedVoxels = 0;
    /// The number of voxels in which they differ, divided by that of the reference (rVE; seed B,
    /// section 7.3). None if only the reference is empty; 0 if both are.
    std::optional<double> relativeVolumeError;
    /// 2 · shared / (sum of both); 1 if both are empty.
    double dice = 1.0;
    /// None if one of them is empty; all 0 if both are.
    std::optional<SurfaceDistances> distances;
};

/// Compares two masks on one grid; slices may be uneven or tilted. Cost: a search in a tree for
/// each voxel of both surfaces, on all cores. Any thread. Errors: Cancelled.
[[nodiscard]] Result<MaskComparison> compareMasks(const VoxelRuns& mask, const VoxelRuns& reference,
    const VolumeGeometry& geometry, const Progress& progress);

} // namespace core

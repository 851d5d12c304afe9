// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/repair/SeriesRepair.h"
#include "core/volume/VolumeGeometry.h"

#include <cstdint>
#include <vector>

namespace core {

/// Offsets and shares of a voxel are whole numbers of this part of it.
constexpr std::int64_t wholeVoxel = std::int64_t(1) << 16;

/// Where the first voxel of a source slice lies in the repaired lattice, in 1/wholeVoxel of its
/// voxels. Its other voxels follow at whole steps: rows and columns of both are the same.
struct LatticePlace {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;

    /// The nearest voxel of the lattice; halves go up.
    [[nodiscard]] glm::ivec3 nearest() const;
};

/// The grid of a repaired volume, and where in it the slices of the source lie.
struct RepairLattice {
    VolumeGeometry geometry;
    std::vector<LatticePlace> places; ///< per slice of the source
};

/// Lays the lattice of SeriesRepair::tilt and ::lattice over slices; neither voxels nor files are
/// needed. Rows and columns keep their directions and spacing; slices follow each other along
/// their normal (`tilt`) or along the line from the first to the last. The lattice grows in its
/// planes until every voxel of every slice is in it.
///
/// The only place where a repair computes in doubles (+, −, ×, ÷ and √, each rounded as IEEE 754
/// says, hence equal everywhere): places are rounded once, to 1/65536 of a voxel, and those nearer
/// than a hundredth to a whole voxel are whole. From there on everything is integers.
[[nodiscard]] RepairLattice repairLattice(const VolumeGeometry& slices, const SeriesRepair& repair);

/// The parts that gap=split:N numbers, as first slice and count: cut where a distance is more than
/// half again that of the slices on either side of it. One part where there is no such place.
struct SlicePart {
    int first = 0; ///< 0-based
    int count = 0;
};
[[nodiscard]] std::vector<SlicePart> gapParts(const VolumeGeometry& slices);

/// The geometry of some of the slices alone.
[[nodiscard]] VolumeGeometry geometryOfPart(const VolumeGeometry& slices, const SlicePart& part);

/// Distances between neighbouring slices along their normal.
[[nodiscard]] std::vector<double> sliceGapsMm(const VolumeGeometry& slices);

/// Why these slices cannot be repaired like that, as a clause; empty if they can.
[[nodiscard]] QString repairObstacle(const VolumeGeometry& slices, const SeriesRepair& repair);

/// The grid after all of a repair but its duplicates, which is a question of images.
/// @param slices for which there is no repairObstacle()
[[nodiscard]] VolumeGeometry repairedGeometry(
    const VolumeGeometry& slices, const SeriesRepair& repair);

} // namespace core

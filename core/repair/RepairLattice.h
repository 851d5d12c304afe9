// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/repair/SeriesRepair.h"
#include "core/volume/VolumeGeometry.h"

#include <cstdint>
#include <vector>

namespace core {

/// Offsets and shares of a voxel are integers in this part of a voxel.
constexpr std::int64_t wholeVoxel = std::int64_t(1) << 16;

/// The position of the first voxel of a source slice in the repaired lattice, in 1/wholeVoxel of
/// the lattice's voxels. The slice's other voxels follow in whole steps, since rows and columns of
/// both are the same.
struct LatticePlace {
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t z = 0;

    /// The nearest voxel of the lattice; halves are rounded up.
    [[nodiscard]] glm::ivec3 nearest() const;
};

/// The grid of a repaired volume, and the positions of the source slices in it.
struct RepairLattice {
    VolumeGeometry geometry;
    std::vector<LatticePlace> places; ///< per slice of the source
};

/// Computes the lattice for SeriesRepair::tilt and ::lattice from the geometry of the slices alone.
/// Rows and columns keep their directions and spacing; slices follow each other along their normal
/// (`tilt`) or along the line from the first to the last. The lattice is enlarged within its planes
/// until it contains every voxel of every slice.
///
/// This is the only place where a repair computes in doubles (+, −, ×, ÷ and √, each rounded
/// according to IEEE 754 and therefore equal on every machine). Positions are rounded once, to
/// 1/65536 of a voxel, and those within a hundredth of a whole voxel are rounded to it. Everything
/// after that is in integers.
[[nodiscard]] RepairLattice repairLattice(const VolumeGeometry& slices, const SeriesRepair& repair);

/// The parts that gap=split:N numbers, as first slice and count. The series is split where a
/// distance is more than one and a half times that of the slices on either side. One part if there
/// is no such place.
struct SliceRun {
    int first = 0; ///< 0-based
    int count = 0;
};
[[nodiscard]] std::vector<SliceRun> gapParts(const VolumeGeometry& slices);

/// The geometry of some of the slices alone.
[[nodiscard]] VolumeGeometry geometryOfPart(const VolumeGeometry& slices, const SliceRun& part);

/// Distances between neighbouring slices along their normal.
[[nodiscard]] std::vector<double> sliceGapsMm(const VolumeGeometry& slices);

/// Why these slices cannot be repaired in this way, as a clause; empty if they can.
[[nodiscard]] Clause repairObstacle(const VolumeGeometry& slices, const SeriesRepair& repair);

/// The grid after a repair, except for its duplicates, which depend on the images.
/// @param slices with an empty repairObstacle()
[[nodiscard]] VolumeGeometry repairedGeometry(
    const VolumeGeometry& slices, const SeriesRepair& repair);

} // namespace core

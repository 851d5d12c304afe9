// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"
#include "core/volume/VolumeGeometry.h"
#include "core/voxelfile/StoredScalars.h"

#include <map>
#include <span>
#include <vector>

namespace core {

/// One number a voxel, on a grid of its own; 0: nothing there.
struct LabelGrid {
    VolumeGeometry geometry;
    std::vector<std::uint16_t> labels;
};

/// Labels from stored numbers. UnsupportedFormat where a value is none: negative, not whole, beyond
/// 65535. @p path: for the sentence
/// @param layers, layer numbers lie one behind the other for each voxel; the one that is taken
[[nodiscard]] Result<std::vector<std::uint16_t>> labelsFrom(std::span<const char> bytes,
    ScalarType type, double slope, double intercept, int layers, int layer, const QString& path);

/// Labels of a grid as voxels of a volume.
struct LabelsOnVolume {
    std::map<int, VoxelRuns> voxels; ///< by label
    bool oneToOne = false; ///< each voxel that is inside both is the same in both
    std::uint64_t labelled = 0; ///< voxels of the grid that have a label
    std::uint64_t outside = 0; ///< of these, those that lie outside the volume
};

/// Each voxel has the label of the grid's voxel that is nearest to its centre (LatticeMap.h), or
/// none where the grid has none. Errors: UnsupportedFormat (@p path).
[[nodiscard]] Result<LabelsOnVolume> labelsOn(
    const VolumeGeometry& volume, const LabelGrid& grid, const QString& path);

} // namespace core

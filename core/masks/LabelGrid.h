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

/// One label per voxel on its own grid; 0: none.
struct LabelGrid {
    VolumeGeometry geometry;
    std::vector<std::uint16_t> labels;
};

/// Converts stored numbers to labels. UnsupportedFormat if a value cannot be a label: negative, not
/// an integer, above 65535.
/// @param layers, layer number of values stored for each voxel, and which of them is used
/// @param path named in the error
[[nodiscard]] Result<std::vector<std::uint16_t>> labelsFrom(std::span<const char> bytes,
    ScalarType type, double slope, double intercept, int layers, int layer, const QString& path);

/// The labels of a grid as voxels of a volume.
struct LabelsOnVolume {
    std::map<int, VoxelRuns> voxels; ///< by label
    bool oneToOne = false; ///< within both, each voxel of one is the same in the other
    std::uint64_t labelled = 0; ///< voxels of the grid that have a label
    std::uint64_t outside = 0; ///< of these, voxels that lie outside the volume
};

/// Each voxel gets the label of the grid's voxel nearest to its centre (LatticeMap.h), or none
/// where the grid has none. Errors: UnsupportedFormat (@p path).
[[nodiscard]] Result<LabelsOnVolume> labelsOn(
    const VolumeGeometry& volume, const LabelGrid& grid, const QString& path);

} // namespace core

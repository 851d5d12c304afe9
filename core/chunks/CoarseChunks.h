// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/chunks/ChunkColours.h"
#include "core/chunks/ChunkTree.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace core {

/// Roughly what the chunks of a large box will be, known in a fraction of the time: pictures show
/// it until the chunks themselves are there. The box is divided into cells of several voxels, each
/// of which is treated as if all of it were like its middle voxel. It decides no voxel. Immutable.
struct CoarseChunks {
    static constexpr std::int64_t mostCells = std::int64_t(1) << 21;

    VoxelBox box;
    int cell = 2; ///< voxels along each axis
    ChunkTree tree; ///< of the cells
    /// By cell of the box, x fastest: its chunk of the finest division + 1, or 0 for none.
    std::shared_ptr<const std::vector<std::uint16_t>> leaves;
    ChunkColours colours;

    /// Cells have as few voxels as @p most allows, but at least two along each axis. Cost: that of
    /// ChunkTree::of() for the cells. Errors: as there.
    /// @param box where the source lies in the volume
    /// @param most the greatest number of cells
    [[nodiscard]] static Result<CoarseChunks> of(const ChunkSource& source, const VoxelBox& box,
        const Progress& progress, std::int64_t most = mostCells);
};

} // namespace core

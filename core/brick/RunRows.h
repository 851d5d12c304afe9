// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>

namespace core {

/// Calls visit(at, count, number) for each part of runs that lies in one row along x, ascending.
/// @param size of the volume whose voxels these are
/// at: the first voxel of the part; count: how many voxels it has; number: that of the first one
template <class Visit>
void forEachRowPart(const VoxelRuns& voxels, const glm::ivec3& size, const Visit& visit)
{
    const auto columns = std::uint64_t(size.x);
    const auto rows = std::uint64_t(size.y);
    for (const VoxelRun& run : voxels.runs()) {
        const std::uint64_t end = run.first + run.count;
        for (std::uint64_t first = run.first; first < end;) {
            const std::uint64_t row = first / columns;
            const std::uint64_t count = std::min((row + 1) * columns, end) - first;
            visit(glm::ivec3(int(first % columns), int(row % rows), int(row / rows)), int(count),
                first);
            first += count;
        }
    }
}

} // namespace core

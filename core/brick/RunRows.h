// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>

namespace core {

/// Cuts runs of voxels where a row along x ends, and calls visit(at, count, number) for each part,
/// in ascending order: `at` is the first voxel of the part, `count` how many voxels it has, and
/// `number` the place of the first voxel among all voxels of the volume, x fastest.
/// @param size of the volume that the runs belong to
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

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
    glm::ivec3 row(0);
    std::uint64_t rowBegin = 0;
    std::uint64_t rowEnd = 0; // no row yet
    for (const VoxelRun& run : voxels.runs()) {
        const std::uint64_t end = run.first + run.count;
        for (std::uint64_t first = run.first; first < end;) {
            // Masks have many runs a row, and divisions take longer than all else here.
            if (first >= rowEnd) {
                const std::uint64_t number = first / columns;
                rowBegin = number * columns;
                rowEnd = rowBegin + columns;
                row = glm::ivec3(0, int(number % rows), int(number / rows));
            }
            const std::uint64_t count = std::min(rowEnd, end) - first;
            visit(row + glm::ivec3(int(first - rowBegin), 0, 0), int(count), first);
            first += count;
        }
    }
}

} // namespace core

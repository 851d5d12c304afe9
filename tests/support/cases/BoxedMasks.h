// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/imports/ImportMask.h"

#include <cstdint>
#include <vector>

namespace test {

/// Returns the voxels of a box in a volume of a given size, as runs of voxel numbers.
[[nodiscard]] inline core::VoxelRuns runsOfBox(const core::VoxelBox& box, const glm::ivec3& size)
{
    core::VoxelRuns runs;
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            runs.append(std::uint64_t((z * size.y + y) * size.x + box.minimum.x),
                std::uint64_t(box.maximum.x - box.minimum.x));
    }
    return runs;
}

/// Returns an import as if it had been read from a file: one segment for each box, named S1, S2 ….
[[nodiscard]] inline core::ImportMask importOfBoxes(
    const std::vector<core::VoxelBox>& boxes, const glm::ivec3& size)
{
    core::ImportMask mask{.file = QStringLiteral("organs.seg.nrrd")};
    mask.size = size;
    mask.segments.emplace();
    for (const core::VoxelBox& box : boxes)
        mask.segments->push_back({.name = QStringLiteral("S%1").arg(mask.segments->size() + 1),
            .rgb = 7,
            .code = {},
            .voxels = core::packedRuns(runsOfBox(box, size))});
    return mask;
}

} // namespace test

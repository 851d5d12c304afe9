// SPDX-License-Identifier: Apache-2.0
#include "core/brick/LabelBox.h"

#include "core/brick/RunRows.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace core {

VoxelBox boxOfLabel(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label)
{
    VoxelBox box{.minimum = glm::ivec3(std::numeric_limits<int>::max()), .maximum = glm::ivec3(0)};
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            const auto* row = &labels[(std::size_t(z) * std::size_t(size.y) + std::size_t(y))
                * std::size_t(size.x)];
            const auto* first =
                static_cast<const std::uint8_t*>(std::memchr(row, label, std::size_t(size.x)));
            if (!first)
                continue;
            const auto* last = row + size.x;
            while (*(last - 1) != label)
                --last;
            box.minimum = glm::min(box.minimum, glm::ivec3(int(first - row), y, z));
            box.maximum = glm::max(box.maximum, glm::ivec3(int(last - row), y + 1, z + 1));
        }
    }
    return box.maximum.x == 0 ? VoxelBox() : box;
}

VoxelBox boxOfRuns(const VoxelRuns& voxels, const glm::ivec3& size)
{
    VoxelBox box;
    forEachRowPart(voxels, size, [&box](const glm::ivec3& at, int count, std::uint64_t) {
        box = box.united({at, at + glm::ivec3(count, 1, 1)});
    });
    return box;
}

} // namespace core

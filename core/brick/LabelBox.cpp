// SPDX-License-Identifier: Apache-2.0
#include "core/brick/LabelBox.h"

#include "core/brick/RunRows.h"

#include <algorithm>
#include <cstring>

namespace core {

namespace {

/// The first column from @p begin to before @p end that holds a label; less than 0: none.
int firstOf(std::uint8_t label, const std::uint8_t* row, int begin, int end)
{
    if (begin >= end)
        return -1;
    const auto* found =
        static_cast<const std::uint8_t*>(std::memchr(row + begin, label, std::size_t(end - begin)));
    return found ? int(found - row) : -1;
}

} // namespace

VoxelBox boxOfLabel(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label)
{
    VoxelBox box{.minimum = size, .maximum = glm::ivec3(0)};
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            const auto* row = &labels[(std::size_t(z) * std::size_t(size.y) + std::size_t(y))
                * std::size_t(size.x)];
            const int first = firstOf(label, row, 0, box.minimum.x);
            bool any = first >= 0;
            if (any)
                box.minimum.x = first;
            // Each voxel found widens the box, so this is seldom repeated.
            for (int last = firstOf(label, row, box.maximum.x, size.x); last >= 0;
                 last = firstOf(label, row, box.maximum.x, size.x)) {
                box.maximum.x = last + 1;
                any = true;
            }
            // What lies within the box's columns matters only in a row that is not in the box yet.
            const bool isNew = z >= box.maximum.z || y < box.minimum.y || y >= box.maximum.y;
            if (!any && (!isNew || firstOf(label, row, box.minimum.x, box.maximum.x) < 0))
                continue;
            box.minimum = glm::min(box.minimum, glm::ivec3(box.minimum.x, y, z));
            box.maximum = glm::max(box.maximum, glm::ivec3(box.maximum.x, y + 1, z + 1));
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

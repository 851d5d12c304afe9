// SPDX-License-Identifier: Apache-2.0
#include "core/refine/voxels/BoxMask.h"

#include <bitset>

namespace core {

namespace {

/// Calls visit(row's first voxel, count) for every piece of a run that lies in one row.
template <typename Visit>
void forEachRowPiece(const VoxelRuns& voxels, const glm::ivec3& size, const Visit& visit)
{
    const auto columns = std::uint64_t(size.x);
    for (const VoxelRun& run : voxels.runs()) {
        std::uint64_t at = run.first;
        std::uint64_t left = run.count;
        while (left > 0) {
            const std::uint64_t row = at / columns;
            const std::uint64_t count = std::min(left, columns - at % columns);
            visit(glm::ivec3(int(at % columns), int(row % std::uint64_t(size.y)),
                      int(row / std::uint64_t(size.y))),
                int(count));
            at += count;
            left -= count;
        }
    }
}

} // namespace

BoxMask::BoxMask(const glm::ivec3& least, const glm::ivec3& most)
    : m_first(least)
    , m_size(most - least + 1)
    , m_bits((std::size_t(m_size.x) * std::size_t(m_size.y) * std::size_t(m_size.z) + 63) / 64, 0)
{
}

BoxMask BoxMask::of(
    std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec3& size)
{
    VoxelRuns voxels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i] == label)
            voxels.append(i, 1);
    }
    return of(voxels, size);
}

BoxMask BoxMask::of(const VoxelRuns& voxels, const glm::ivec3& size)
{
    if (voxels.empty())
        return {};
    glm::ivec3 least = size;
    glm::ivec3 most(-1);
    forEachRowPiece(voxels, size, [&](const glm::ivec3& voxel, int count) {
        least = glm::min(least, voxel);
        most = glm::max(most, voxel + glm::ivec3(count - 1, 0, 0));
    });
    BoxMask mask(least, most);
    forEachRowPiece(voxels, size, [&](const glm::ivec3& voxel, int count) {
        for (int x = 0; x < count; ++x)
            mask.add(voxel + glm::ivec3(x, 0, 0));
    });
    return mask;
}

std::uint64_t BoxMask::voxelCount() const
{
    std::uint64_t count = 0;
    for (const std::uint64_t word : m_bits)
        count += std::bitset<64>(word).count();
    return count;
}

glm::u64vec3 BoxMask::borderFaces() const
{
    glm::u64vec3 faces(0);
    for (int z = 0; z < m_size.z; ++z) {
        for (int y = 0; y < m_size.y; ++y) {
            for (int x = 0; x < m_size.x; ++x) {
                const glm::ivec3 voxel = m_first + glm::ivec3(x, y, z);
                if (!contains(voxel))
                    continue;
                for (int axis = 0; axis < 3; ++axis) {
                    glm::ivec3 step(0);
                    step[axis] = 1;
                    faces[axis] += contains(voxel - step) ? 0U : 1U;
                    faces[axis] += contains(voxel + step) ? 0U : 1U;
                }
            }
        }
    }
    return faces;
}

} // namespace core

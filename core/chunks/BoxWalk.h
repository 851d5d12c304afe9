// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>

namespace core {

/// Iterates over the voxels of a box, numbered x fastest, and over their neighbours (six).
class BoxWalk {
public:
    explicit BoxWalk(const glm::ivec3& size)
        : m_size(size)
        , m_row(std::size_t(size.x))
        , m_slice(std::size_t(size.x) * std::size_t(size.y))
    {
    }

    [[nodiscard]] std::size_t voxels() const { return m_slice * std::size_t(m_size.z); }
    [[nodiscard]] glm::ivec3 placeOf(std::size_t voxel) const
    {
        return {
            int(voxel % m_row), int(voxel / m_row % std::size_t(m_size.y)), int(voxel / m_slice)};
    }

    /// Visits each pair of neighbours once, ascending by the first.
    template <class Visit> void forEachPair(Visit visit) const
    {
        std::size_t voxel = 0;
        for (int z = 0; z < m_size.z; ++z) {
            for (int y = 0; y < m_size.y; ++y) {
                for (int x = 0; x < m_size.x; ++x, ++voxel) {
                    if (x + 1 < m_size.x)
                        visit(voxel, voxel + 1);
                    if (y + 1 < m_size.y)
                        visit(voxel, voxel + m_row);
                    if (z + 1 < m_size.z)
                        visit(voxel, voxel + m_slice);
                }
            }
        }
    }

    template <class Visit> void forEachNeighbour(std::size_t voxel, Visit visit) const
    {
        const glm::ivec3 place = placeOf(voxel);
        if (place.x > 0)
            visit(voxel - 1);
        if (place.x + 1 < m_size.x)
            visit(voxel + 1);
        if (place.y > 0)
            visit(voxel - m_row);
        if (place.y + 1 < m_size.y)
            visit(voxel + m_row);
        if (place.z > 0)
            visit(voxel - m_slice);
        if (place.z + 1 < m_size.z)
            visit(voxel + m_slice);
    }

private:
    glm::ivec3 m_size;
    std::size_t m_row;
    std::size_t m_slice;
};

} // namespace core

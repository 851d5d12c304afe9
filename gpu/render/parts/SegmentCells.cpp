// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/SegmentCells.h"

#include "gpu/fields/textures/ChebyshevDistance.h"
#include "gpu/fields/textures/VolumeTextures.h"

#include <vector>

namespace gpu {

const Texture3D& SegmentCells::distances(VolumeTextures& volume)
{
    const glm::ivec3 cells = volume.cells().cells();
    const bool fits = m_distances && m_distances.size() == cells;
    if (fits && m_revision == volume.revision())
        return m_distances;
    if (!fits)
        m_distances =
            Texture3D({.label = "distances to segments", .size = cells, .format = GL_R8UI});
    std::vector<std::uint8_t> occupied(
        std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z));
    for (const glm::ivec3& cell : volume.cells().segmentCells())
        occupied[std::size_t((cell.z * cells.y + cell.y) * cells.x + cell.x)] = 1;
    m_distances.upload<std::uint8_t>(chebyshevDistance(cells, occupied));
    m_revision = volume.revision();
    return m_distances;
}

} // namespace gpu

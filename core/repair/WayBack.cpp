// SPDX-License-Identifier: Apache-2.0
#include "core/repair/WayBack.h"

#include "core/repair/RepairLattice.h"
#include "core/repair/RepairVolume.h"

#include <algorithm>

namespace core {

std::optional<WayBack> WayBack::of(const Volume& volume)
{
    const std::optional<SeriesRepair> repair = SeriesRepair::fromText(volume.repair);
    if (!volume.asIs || !repair || !repair->movesVoxels())
        return std::nullopt;
    return WayBack(volume);
}

WayBack::WayBack(const Volume& volume)
    : m_repairedSize(volume.geometry.size)
    , m_slices(volume)
{
    const SeriesRepair repair = *SeriesRepair::fromText(volume.repair);
    const SeriesAsIs& asIs = *volume.asIs;
    SliceRun part{.first = 0, .count = asIs.geometry.size.z};
    if (repair.part != 0)
        part = gapParts(asIs.geometry)[std::size_t(repair.part - 1)];
    // On these nothing was moved; what was is known of the whole volume only.
    m_slices.repair = repairMade(volume);
    m_slices.asIs.reset();
    m_slices.geometry = geometryOfPart(asIs.geometry, part);
    m_slices.sources = {
        asIs.sources.begin() + part.first, asIs.sources.begin() + part.first + part.count};
    for (const LatticePlace& place : repairLattice(m_slices.geometry, repair).places)
        m_firstVoxels.push_back(place.nearest());
}

std::vector<std::uint8_t> WayBack::labels(std::span<const std::uint8_t> repaired) const
{
    const glm::ivec3 size = m_slices.geometry.size;
    std::vector<std::uint8_t> labels(m_slices.geometry.voxelCount());
    auto to = labels.begin();
    for (int k = 0; k < size.z; ++k) {
        const glm::ivec3& first = m_firstVoxels[std::size_t(k)];
        for (int j = 0; j < size.y; ++j) {
            const std::size_t row =
                (std::size_t(first.z) * std::size_t(m_repairedSize.y) + std::size_t(first.y + j))
                    * std::size_t(m_repairedSize.x)
                + std::size_t(first.x);
            to = std::copy_n(repaired.begin() + std::ptrdiff_t(row), size.x, to);
        }
    }
    return labels;
}

} // namespace core

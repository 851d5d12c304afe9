// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/IslandTruth.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace test {

using namespace core;

namespace {

struct IslandPart {
    std::vector<std::size_t> voxels; ///< the first one is the first in memory
    bool isAtBorder = false;
};

/// The parts of what is, or is not, of a label.
class IslandParts {
public:
    IslandParts(const glm::ivec3& size, std::span<const std::uint8_t> labels, int label)
        : m_size(size)
        , m_labels(labels)
        , m_label(label)
    {
    }

    /// @param isOf the label's own voxels, which touch at corners too, or all others, by faces
    [[nodiscard]] std::vector<IslandPart> find(bool isOf) const
    {
        std::vector<IslandPart> parts;
        std::vector<bool> isSeen(m_labels.size(), false);
        for (std::size_t first = 0; first < m_labels.size(); ++first) {
            if (isSeen[first] || (m_labels[first] == m_label) != isOf)
                continue;
            IslandPart part;
            isSeen[first] = true;
            part.voxels.push_back(first);
            for (std::size_t done = 0; done < part.voxels.size(); ++done)
                fillFrom(part.voxels[done], isOf, isSeen, part);
            parts.push_back(std::move(part));
        }
        return parts;
    }

private:
    void fillFrom(std::size_t voxel, bool isOf, std::vector<bool>& isSeen, IslandPart& part) const
    {
        const glm::ivec3 place(int(voxel % std::size_t(m_size.x)),
            int(voxel / std::size_t(m_size.x)) % m_size.y,
            int(voxel / std::size_t(m_size.x)) / m_size.y);
        for (int step = 0; step < 27; ++step) {
            const glm::ivec3 by(step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
            const int axes = std::abs(by.x) + std::abs(by.y) + std::abs(by.z);
            if (axes == 0 || (!isOf && axes > 1))
                continue;
            const glm::ivec3 next = place + by;
            if (glm::clamp(next, glm::ivec3(0), m_size - 1) != next) {
                part.isAtBorder = true;
                continue;
            }
            const std::size_t at =
                (std::size_t(next.z) * std::size_t(m_size.y) + std::size_t(next.y))
                    * std::size_t(m_size.x)
                + std::size_t(next.x);
            if (isSeen[at] || (m_labels[at] == m_label) != isOf)
                continue;
            isSeen[at] = true;
            part.voxels.push_back(at);
        }
    }

    glm::ivec3 m_size;
    std::span<const std::uint8_t> m_labels;
    int m_label;
};

/// By looking at all of them.
std::size_t nearestVoxel(const glm::dvec3& placeLps, const VolumeGeometry& geometry)
{
    std::size_t nearest = 0;
    double leastMm = 1e300;
    std::size_t at = 0;
    for (int z = 0; z < geometry.size.z; ++z) {
        for (int y = 0; y < geometry.size.y; ++y) {
            for (int x = 0; x < geometry.size.x; ++x, ++at) {
                const double offMm = glm::distance(geometry.toWorld(glm::dvec3(x, y, z)), placeLps);
                if (offMm < leastMm) {
                    leastMm = offMm;
                    nearest = at;
                }
            }
        }
    }
    return nearest;
}

} // namespace

std::vector<bool> islandVoxels(
    const CleanSegment& edit, const VolumeGeometry& geometry, std::span<const std::uint8_t> labels)
{
    std::vector<bool> meant(labels.size(), false);
    const auto take = [&meant](const IslandPart& part) {
        for (const std::size_t voxel : part.voxels)
            meant[voxel] = true;
    };
    const IslandParts all(geometry.size, labels, edit.segment);
    const glm::dvec3 spacing = geometry.spacingMm();
    const double voxelMm3 = spacing.x * spacing.y * spacing.z;
    const auto mm3 = [voxelMm3](
                         const IslandPart& part) { return voxelMm3 * double(part.voxels.size()); };
    if (edit.rule == IslandRule::FillHoles) {
        for (const IslandPart& hole : all.find(false)) {
            if (!hole.isAtBorder && (!edit.mm3 || mm3(hole) <= *edit.mm3))
                take(hole);
        }
        return meant;
    }
    const std::vector<IslandPart> islands = all.find(true);
    const std::size_t clicked = edit.islandLps ? nearestVoxel(*edit.islandLps, geometry) : 0;
    const auto isClicked = [clicked](const IslandPart& island) {
        return std::find(island.voxels.begin(), island.voxels.end(), clicked)
            != island.voxels.end();
    };
    const auto largest = std::max_element(
        islands.begin(), islands.end(), [](const IslandPart& one, const IslandPart& other) {
            return one.voxels.size() < other.voxels.size();
        });
    for (auto island = islands.begin(); island != islands.end(); ++island) {
        const bool goes = edit.rule == IslandRule::KeepLargest ? island != largest
            : edit.rule == IslandRule::RemoveSmall             ? mm3(*island) < *edit.mm3
            : edit.rule == IslandRule::KeepClicked             ? !isClicked(*island)
                                                               : isClicked(*island);
        if (goes)
            take(*island);
    }
    return meant;
}

std::vector<std::vector<std::size_t>> islandsBySize(
    const glm::ivec3& size, std::span<const std::uint8_t> labels, int segment)
{
    std::vector<std::vector<std::size_t>> islands;
    for (IslandPart& part : IslandParts(size, labels, segment).find(true))
        islands.push_back(std::move(part.voxels));
    std::stable_sort(islands.begin(), islands.end(),
        [](const auto& one, const auto& other) { return one.size() > other.size(); });
    return islands;
}

} // namespace test

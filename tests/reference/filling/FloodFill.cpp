// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/filling/FloodFill.h"

#include <cmath>
#include <cstdlib>

namespace reference {

namespace {

struct Voxels {
    glm::ivec3 size;

    [[nodiscard]] std::size_t at(const glm::ivec3& voxel) const
    {
        return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
            * std::size_t(size.x)
            + std::size_t(voxel.x);
    }
    [[nodiscard]] bool holds(const glm::ivec3& voxel) const
    {
        return voxel.x >= 0 && voxel.y >= 0 && voxel.z >= 0 && voxel.x < size.x && voxel.y < size.y
            && voxel.z < size.z;
    }
};

/// Whether a neighbour that counts was found before.
bool touchesFound(const core::FloodFill& edit, const Voxels& grid, const glm::ivec3& voxel,
    const std::vector<bool>& found)
{
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const bool byFace = std::abs(x) + std::abs(y) + std::abs(z) == 1;
                const glm::ivec3 next = voxel + glm::ivec3(x, y, z);
                if ((byFace || edit.corners) && grid.holds(next) && found[grid.at(next)])
                    return true;
            }
        }
    }
    return false;
}

} // namespace

std::vector<bool> floodedVoxels(const core::FloodFill& edit, const core::LoadedVolume& study,
    std::span<const std::uint8_t> labels)
{
    const core::VolumeGeometry& geometry = study.volume.geometry;
    const Voxels grid{geometry.size};
    const glm::dvec3 index = geometry.toIndex(edit.placeLps);
    const glm::ivec3 first{int(std::floor(index.x + 0.5)), int(std::floor(index.y + 0.5)),
        int(std::floor(index.z + 0.5))};
    const auto valueAt = [&](std::size_t voxel) {
        return study.volume.encoding.value(study.codes[voxel]);
    };
    const double value = valueAt(grid.at(first));
    const auto mayBelong = [&](const glm::ivec3& voxel) {
        if (edit.within && voxel[alongOf(*edit.within)] != first[alongOf(*edit.within)])
            return false;
        if (edit.erase)
            return int(labels[grid.at(voxel)]) == edit.segment;
        return std::abs(valueAt(grid.at(voxel)) - value) <= edit.tolerance;
    };
    std::vector<bool> found(study.codes.size(), false);
    found[grid.at(first)] = mayBelong(first);
    // To and fro, so that what winds about takes few sweeps.
    bool forth = true;
    for (bool more = found[grid.at(first)]; more; forth = !forth) {
        more = false;
        for (std::size_t step = 0; step < found.size(); ++step) {
            const std::size_t at = forth ? step : found.size() - 1 - step;
            const auto columns = std::size_t(grid.size.x);
            const auto rows = std::size_t(grid.size.y);
            const glm::ivec3 voxel{
                int(at % columns), int(at / columns % rows), int(at / columns / rows)};
            if (found[at] || !mayBelong(voxel) || !touchesFound(edit, grid, voxel, found))
                continue;
            found[at] = true;
            more = true;
        }
    }
    return found;
}

} // namespace reference

// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/BorderVoxels.h"

#include "core/volume/UnevenSlices.h"

namespace core {

namespace {

/// Walks along a mask's runs, asked in ascending order whether they hold voxels.
class RunCursor {
public:
    explicit RunCursor(const VoxelRuns& runs)
        : m_at(runs.runs().begin())
        , m_end(runs.runs().end())
    {
    }
    [[nodiscard]] bool holds(std::uint64_t voxel)
    {
        while (m_at != m_end && m_at->first + m_at->count <= voxel)
            ++m_at;
        return m_at != m_end && m_at->first <= voxel;
    }

private:
    std::vector<VoxelRun>::const_iterator m_at;
    std::vector<VoxelRun>::const_iterator m_end;
};

} // namespace

std::vector<glm::dvec3> borderVoxels(const VoxelRuns& mask, const VolumeGeometry& geometry)
{
    const auto row = std::uint64_t(geometry.size.x);
    const auto rows = std::uint64_t(geometry.size.y);
    const std::uint64_t slice = row * rows;
    const auto slices = std::uint64_t(geometry.size.z);
    // Each of the four is asked in ascending order, as voxels are.
    RunCursor above(mask);
    RunCursor below(mask);
    RunCursor before(mask);
    RunCursor behind(mask);
    std::vector<glm::dvec3> places;
    for (const VoxelRun& run : mask.runs()) {
        const std::uint64_t last = run.first + run.count - 1;
        for (std::uint64_t voxel = run.first; voxel <= last; ++voxel) {
            const std::uint64_t x = voxel % row;
            const std::uint64_t y = voxel / row % rows;
            const std::uint64_t z = voxel / slice;
            const bool inner = x > 0 && x + 1 < row && voxel > run.first && voxel < last && y > 0
                && y + 1 < rows && z > 0 && z + 1 < slices && above.holds(voxel - row)
                && below.holds(voxel + row) && before.holds(voxel - slice)
                && behind.holds(voxel + slice);
            if (!inner)
                places.push_back(worldBetweenSlices(geometry, {double(x), double(y), double(z)}));
        }
    }
    return places;
}

} // namespace core

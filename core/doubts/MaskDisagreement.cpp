// SPDX-License-Identifier: Apache-2.0
#include "core/doubts/MaskDisagreement.h"

#include "core/brick/VoxelRunSets.h"
#include "core/doubts/PartMiddle.h"
#include "core/islands/VoxelIslands.h"

#include <algorithm>
#include <array>
#include <limits>

namespace core {

namespace {

/// The index of a run that holds a voxel, or of none.
constexpr std::size_t noRun = std::numeric_limits<std::size_t>::max();

std::size_t runWith(const std::vector<VoxelRun>& runs, std::uint64_t number)
{
    const auto behind = std::upper_bound(runs.begin(), runs.end(), number,
        [](std::uint64_t wanted, const VoxelRun& run) { return wanted < run.first; });
    if (behind == runs.begin())
        return noRun;
    const auto at = behind - 1;
    return number < at->first + at->count ? std::size_t(at - runs.begin()) : noRun;
}

/// A run of a core, and the part that it belongs to.
struct PartRun {
    VoxelRun run;
    std::size_t part = 0;
};

/// Walks along the neighbours of voxels, across the axes that count.
class Neighbours {
public:
    explicit Neighbours(const VolumeGeometry& geometry)
        : m_size(geometry.size)
    {
        const glm::i64vec3 side = spacingUm(geometry);
        const std::int64_t finest = std::min({side.x, side.y, side.z});
        for (int axis = 0; axis < 3; ++axis)
            m_counts[std::size_t(axis)] = side[axis] < 2 * finest;
    }

    /// Calls visit(number) until it returns false. What is not in the volume is left out.
    /// @return whether it never did
    template <class Visit> bool each(std::uint64_t number, const Visit& visit) const
    {
        const glm::ivec3 at = voxelOf(number, m_size);
        std::uint64_t step = 1;
        for (int axis = 0; axis < 3; ++axis) {
            if (m_counts[std::size_t(axis)]) {
                if (at[axis] > 0 && !visit(number - step))
                    return false;
                if (at[axis] + 1 < m_size[axis] && !visit(number + step))
                    return false;
            }
            step *= std::uint64_t(m_size[axis]);
        }
        return true;
    }

private:
    glm::ivec3 m_size;
    std::array<bool, 3> m_counts{};
};

/// Ends early when the work is cancelled, which it asks every few thousand voxels.
template <class Visit>
void forEachNumber(const VoxelRuns& voxels, const Progress& progress, const Visit& visit)
{
    for (const VoxelRun& run : voxels.runs()) {
        for (std::uint64_t number = run.first; number < run.first + run.count; ++number) {
            if ((number - run.first) % 4096 == 0 && progress.cancelled())
                return;
            visit(number);
        }
    }
}

} // namespace

Result<std::vector<LonePart>> onlyIn(const VoxelRuns& mask, const VoxelRuns& other,
    const VolumeGeometry& geometry, const Progress& progress)
{
    const VoxelRuns difference = common(differing(mask, other), mask);
    const Neighbours neighbours(geometry);
    VoxelRuns cores;
    forEachNumber(difference, progress, [&](std::uint64_t number) {
        const auto differs = [&](std::uint64_t near) {
            return runWith(difference.runs(), near) != noRun;
        };
        if (neighbours.each(number, differs))
            cores.append(number, 1);
    });
    Result<std::vector<VoxelRuns>> islands = islandsOf(cores, geometry.size, 1, progress);
    if (progress.cancelled() || !islands)
        return failure(ErrorCode::Cancelled);

    std::vector<LonePart> parts;
    std::vector<PartRun> byRun;
    for (VoxelRuns& island : *islands) {
        for (const VoxelRun& run : island.runs())
            byRun.push_back({run, parts.size()});
        parts.push_back({.core = std::move(island)});
    }
    std::sort(byRun.begin(), byRun.end(),
        [](const PartRun& one, const PartRun& two) { return one.run.first < two.run.first; });
    std::vector<VoxelRun> coreRuns;
    for (const PartRun& each : byRun)
        coreRuns.push_back(each.run);
    forEachNumber(difference, progress, [&](std::uint64_t number) {
        std::size_t run = runWith(coreRuns, number);
        if (run == noRun)
            neighbours.each(number, [&](std::uint64_t near) {
                run = runWith(coreRuns, near);
                return run == noRun;
            });
        if (run != noRun)
            ++parts[byRun[run].part].voxels;
    });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    std::stable_sort(parts.begin(), parts.end(),
        [](const LonePart& one, const LonePart& two) { return one.voxels > two.voxels; });
    return parts;
}

} // namespace core

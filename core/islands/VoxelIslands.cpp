// SPDX-License-Identifier: Apache-2.0
#include "core/islands/VoxelIslands.h"

#include "core/islands/RunParts.h"

#include <algorithm>

namespace core {

namespace {

/// The runs by rows of the whole volume; runs that continue over the end of a row are cut there.
RunParts partsOfRuns(const VoxelRuns& voxels, const glm::ivec3& size)
{
    RunParts parts(size, 1);
    const auto columns = std::uint64_t(size.x);
    const std::size_t rows = std::size_t(size.y) * std::size_t(size.z);
    std::size_t row = 0;
    const auto goTo = [&](std::size_t wanted) {
        while (row < wanted)
            parts.beginRow(++row);
    };
    for (const VoxelRun& run : voxels.runs()) {
        std::uint64_t at = run.first;
        std::uint64_t left = run.count;
        while (left > 0) {
            const std::uint64_t column = at % columns;
            const std::uint64_t count = std::min(left, columns - column);
            goTo(std::size_t(at / columns));
            parts.add(int(column), int(column + count));
            at += count;
            left -= count;
        }
    }
    goTo(rows - 1);
    parts.endRows();
    return parts;
}

} // namespace

Result<std::vector<VoxelRuns>> islandsOf(
    const VoxelRuns& voxels, const glm::ivec3& size, std::int64_t least, const Progress& progress)
{
    std::vector<VoxelRuns> islands;
    if (voxels.empty())
        return islands;
    RunParts parts = partsOfRuns(voxels, size);
    if (!parts.join(progress))
        return failure(ErrorCode::Cancelled);
    std::vector<std::int64_t> sizes(parts.count(), 0);
    for (std::size_t at = 0; at < parts.count(); ++at)
        sizes[parts.partOf(at)] += parts.run(at).end - parts.run(at).begin;
    std::vector<std::size_t> places(parts.count(), 0); // by the number of the part
    parts.forEach([&](std::size_t at, int y, int z) {
        const std::uint32_t part = parts.partOf(at);
        if (sizes[part] < least)
            return;
        if (part == at) {
            places[part] = islands.size();
            islands.emplace_back();
        }
        const RunParts::Run& run = parts.run(at);
        const std::uint64_t row =
            (std::uint64_t(z) * std::uint64_t(size.y) + std::uint64_t(y)) * std::uint64_t(size.x);
        islands[places[part]].append(
            row + std::uint64_t(run.begin), std::uint64_t(run.end - run.begin));
    });
    return islands;
}

} // namespace core

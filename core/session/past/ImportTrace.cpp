// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/ImportTrace.h"

#include "core/brick/BrickGrid.h"
#include "core/brick/RunRows.h"
#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/imports/ImportMask.h"

#include <utility>

namespace core {

namespace {

void addBricksOf(const VoxelRuns& voxels, const BrickGrid& grid, std::vector<bool>& bricks)
{
    forEachRowPart(voxels, grid.volumeSize, [&](const glm::ivec3& first, int count, std::uint64_t) {
        const int end = first.x + count;
        for (int x = first.x; x < end; x += BrickGrid::side - x % BrickGrid::side)
            bricks[std::size_t(grid.brickOf({x, first.y, first.z}))] = true;
    });
}

} // namespace

void ImportTrace::note(RowId row, const Edit& edit)
{
    const auto* mask = edit.as<ImportMask>();
    if (!mask)
        return;
    std::vector<QByteArray>& packed = m_packed[row];
    packed.clear();
    for (const ImportedSegment& each : mask->segments.value_or(std::vector<ImportedSegment>()))
        packed.push_back(each.voxels);
}

void ImportTrace::workOut(const glm::ivec3& size, const Progress& progress)
{
    const BrickGrid grid{size};
    const auto voxelCount = std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
    std::size_t all = 0;
    for (const auto& [row, packed] : m_packed)
        all += packed.size();
    int done = 0;
    for (const auto& [row, packed] : std::exchange(m_packed, {})) {
        std::vector<bool> has(std::size_t(grid.brickCount()), false);
        for (const QByteArray& bytes : packed) {
            if (progress.cancelled())
                return;
            progress.report(ProgressStep::PlacingMask, done++, int(all));
            if (const auto voxels = unpackedRuns(bytes, voxelCount))
                addBricksOf(*voxels, grid, has);
        }
        std::set<std::uint32_t>& bricks = m_bricks[row];
        for (std::size_t brick = 0; brick < has.size(); ++brick) {
            if (has[brick])
                bricks.insert(bricks.end(), std::uint32_t(brick));
        }
    }
}

std::optional<std::set<std::uint32_t>> ImportTrace::bricksOf(RowId row) const
{
    const auto known = m_bricks.find(row);
    return known == m_bricks.end() ? std::nullopt : std::optional(known->second);
}

} // namespace core

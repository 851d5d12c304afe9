// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/GrowToClosure.h"

#include "core/engine/EngineCommands.h"

#include <chrono>

namespace test {

namespace {

void paste(
    const core::BrickChange& change, const core::BrickGrid& grid, std::vector<std::uint8_t>& mask)
{
    if (change.key.field != core::Field::Labels || change.after.empty())
        return;
    const core::VoxelBox box = grid.boxOf(static_cast<int>(change.key.brick));
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                const auto offset =
                    static_cast<std::size_t>(core::BrickGrid::offsetInBrick({x, y, z}));
                const auto index = (static_cast<std::size_t>(z) * std::size_t(grid.volumeSize.y)
                                       + static_cast<std::size_t>(y))
                        * std::size_t(grid.volumeSize.x)
                    + static_cast<std::size_t>(x);
                mask[index] = change.after.read()[offset];
            }
        }
    }
}

} // namespace

GrownVoxels growToClosure(core::EditEngine& engine, const glm::ivec3& size,
    std::span<const glm::ivec3> seeds, int lowCode, int highCode, const core::GrowLimits& limits)
{
    GrownVoxels grown;
    const auto start = std::chrono::steady_clock::now();
    core::SeedPlacement placement;
    placement.label = 1;
    placement.voxels.assign(seeds.begin(), seeds.end());
    core::submitWhole(engine, placement);
    core::GrowBurst burst;
    burst.lowCode = lowCode;
    burst.highCode = highCode;
    burst.limits = limits;
    const auto spent = [start] {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count();
    };
    engine.submit(core::BeginEdit{burst});
    engine.submit(core::ExtendEdit{core::GrowAdvance{core::GrowAdvance::toClosure}});
    engine.finish();
    grown.closureMilliseconds = spent();
    const core::Ticket ticket = engine.submit(core::EndEdit{core::Ending::Commit});
    engine.finish();
    const std::vector<core::EngineResult> results = engine.collect();
    grown.milliseconds = spent();

    for (const core::EngineResult& result : results) {
        if (result.error)
            return {};
        if (result.ticket != ticket || !result.atClosure)
            continue;
        grown.generation = result.generation;
        grown.mask.assign(
            std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), std::uint8_t{0});
        const core::BrickGrid grid{size};
        for (const core::BrickChange& change : result.changes)
            paste(change, grid, grown.mask);
    }
    return grown;
}

std::vector<glm::ivec3> seedsOnDiagonal(
    const glm::ivec3& size, std::span<const std::uint16_t> codes, int low, int high)
{
    constexpr int looks = 256;
    std::vector<glm::ivec3> seeds;
    for (int i = 0; i < looks; ++i) {
        const glm::ivec3 voxel = size * i / looks;
        const int code = codes[(std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
                * std::size_t(size.x)
            + std::size_t(voxel.x)];
        if (code >= low && code <= high && (seeds.empty() || seeds.back() != voxel))
            seeds.push_back(voxel);
    }
    return seeds;
}

} // namespace test

// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/GpuEditEngine.h"

#include "core/growth/SeedWord.h"
#include "gpu/fields/BrickImages.h"
#include "gpu/gl/GlFailure.h"

#include <algorithm>
#include <chrono>
#include <map>

namespace gpu {

// GpuEditEngine, the part that answers questions: nothing here writes a voxel.

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::ReadBricks& command)
{
    if (const core::Result<void> checked = checkKeys(command.keys); !checked)
        return tl::unexpected(checked.error());
    auto images = readImages(*m_fields, command.keys);
    core::EngineResult result;
    for (std::size_t i = 0; i < images.size(); ++i)
        result.changes.push_back(
            {.key = command.keys[i], .before = {}, .after = std::move(images[i])});
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::ReadBarriers& command)
{
    core::ReadBricks read;
    for (const std::uint32_t brick : m_fields->bricksWithBarriers(command.plane))
        read.keys.push_back({core::Field::SeedWords, command.plane, brick});
    return carryOut(read);
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::ReadSeedWords& command)
{
    std::map<std::uint32_t, std::vector<std::size_t>> places; // in the list, by brick
    for (std::size_t i = 0; i < command.voxels.size(); ++i) {
        const glm::ivec3& voxel = command.voxels[i];
        if (glm::any(glm::lessThan(voxel, glm::ivec3(0)))
            || glm::any(glm::greaterThanEqual(voxel, m_fields->grid().volumeSize)))
            return refusal("voxels", core::Clause::saying("outside the volume"));
        places[std::uint32_t(m_fields->grid().brickOf(voxel))].push_back(i);
    }
    std::vector<core::BrickKey> keys;
    for (const auto& [brick, voxels] : places)
        keys.push_back({.field = core::Field::SeedWords, .plane = command.plane, .brick = brick});
    const auto images = readImages(*m_fields, keys);
    core::EngineResult result;
    result.seedWords.resize(command.voxels.size(), core::seedWord::unvisited);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (images[i].empty())
            continue;
        for (const std::size_t place : places[keys[i].brick]) {
            const int offset = core::BrickGrid::offsetInBrick(command.voxels[place]);
            result.seedWords[place] = core::seedWord::wordAt(&images[i][std::size_t(4 * offset)]);
        }
    }
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::ReadCodes& command)
{
    const core::VoxelBox& box = command.box;
    if (box.empty() || glm::any(glm::lessThan(box.minimum, glm::ivec3(0)))
        || glm::any(glm::greaterThan(box.maximum, m_fields->grid().volumeSize)))
        return refusal("box", core::Clause::saying("is empty or not within the volume"));
    const glm::ivec3 size = box.maximum - box.minimum;
    core::EngineResult result;
    result.codes.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    m_fields->codes().read(
        box.minimum, size, std::as_writable_bytes(std::span<std::uint16_t>(result.codes)));
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::ProbeVoxels& command)
{
    for (const glm::ivec3& voxel : command.voxels) {
        if (glm::any(glm::lessThan(voxel, glm::ivec3(0)))
            || glm::any(glm::greaterThanEqual(voxel, m_fields->grid().volumeSize)))
            return refusal("voxels", core::Clause::saying("outside the volume"));
    }
    core::EngineResult result;
    result.probes = m_picks.probe(*m_fields, command);
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::ProbeSeeds& command)
{
    if (const core::Result<void> checked = core::checkSound(command.seedGroups, m_fields->grid());
        !checked)
        return tl::unexpected(checked.error());
    const core::GroupedSeedSums sums =
        seedSums(m_programs.growth.seedStatistics, *m_fields, command);
    core::EngineResult result;
    for (std::size_t group = 0; group < sums.groups.size(); ++group) {
        if (sums.groups[group].voxels > 0)
            result.seeds.push_back({command.seedGroups[group].label, sums.groups[group], group});
    }
    for (std::size_t label = 0; label < sums.others.size(); ++label) {
        if (sums.others[label].voxels > 0)
            result.seeds.push_back({std::uint8_t(label), sums.others[label], {}});
    }
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::PickVoxels& command)
{
    if (command.seenBy == core::SeenBy::Opacity && command.opacityOfCode.size() != 256)
        return refusal("opacityOfCode", core::Clause::saying("has 256 entries"));
    core::EngineResult result;
    result.picks = m_picks.pick(*m_fields, command);
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::CountGenerations& command)
{
    core::EngineResult result;
    result.generationSizes = generationSizes(m_programs.growth.shrink, *m_fields, command.plane);
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::TraceTolerance& command)
{
    if (m_transaction)
        return refusal("transaction", core::Clause::saying("an edit is open"));
    const Clock::time_point start = Clock::now();
    if (!m_trace || m_trace->done() || !(m_trace->rule() == command.rule)) {
        m_trace.reset();
        auto begun = ToleranceKernel::begin(m_programs.tolerance, *m_fields, command.rule);
        if (!begun)
            return tl::unexpected(begun.error());
        m_trace = *std::move(begun);
    }
    while (!m_trace->done() && (command.toTheEnd || millisecondsSince(start) < sliceMilliseconds)) {
        const Clock::time_point before = Clock::now();
        m_trace->advance(m_tracedAtOnce);
        requireNoError(); // in a lost context it would go on for ever
        const double milliseconds = millisecondsSince(before);
        if (milliseconds > sliceMilliseconds)
            m_tracedAtOnce = std::max(m_tracedAtOnce / 2, leastTraced);
        else if (milliseconds < sliceMilliseconds / 2.0)
            m_tracedAtOnce = std::min(m_tracedAtOnce * 2, mostTraced);
    }
    core::EngineResult result;
    if (m_trace->done())
        result.tolerance = m_fields->tolerance().curve;
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::DropTolerance&)
{
    m_trace.reset();
    m_fields->dropTolerance();
    return core::EngineResult{};
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::PreviewCut& command)
{
    if (m_transaction)
        return refusal("transaction", core::Clause::saying("an edit is open"));
    if (const core::Result<void> checked = core::checkSound(command.cut, m_fields->grid());
        !checked)
        return tl::unexpected(checked.error());
    core::Result<std::optional<core::CutPreview>> cutPreview =
        m_cutPreviewer.ask(*m_fields, command);
    if (!cutPreview)
        return tl::unexpected(cutPreview.error());
    core::EngineResult result;
    result.cutPreview = *std::move(cutPreview);
    return result;
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::DropCutPreview&)
{
    m_cutPreviewer.forget();
    if (!m_transaction)
        m_growthMarks.forget();
    return core::EngineResult{};
}

GpuEditEngine::Outcome GpuEditEngine::carryOut(const core::CompareGrowth& command)
{
    const auto why = m_transaction ? m_transaction->abandoned() : std::optional<core::Error>();
    if (why)
        return tl::unexpected(*why);
    const auto plane =
        m_transaction ? m_transaction->growingPlane() : std::optional<std::uint8_t>();
    if (!plane)
        return refusal("transaction", core::Clause::saying("no growth is open"));
    ComparedGrowth compared = m_transaction->compareGrowth();
    m_growthMarks.show(*m_fields, std::move(compared.bricks), command.keep);
    core::EngineResult result;
    result.growthComparison = compared.counts;
    return result;
}

} // namespace gpu

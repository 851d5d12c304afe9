// SPDX-License-Identifier: Apache-2.0
// Oracle: what changes nothing.
#include "tests/reference/Oracle.h"

#include "core/growth/SeedWord.h"
#include "tests/reference/growth/GrowthCut.h"

#include <algorithm>

namespace reference {

namespace {

auto refuse(const char* field, const char* reason)
{
    return core::failure(
        core::ErrorCode::InvalidField, QLatin1String(field), QLatin1String(reason));
}

} // namespace

Oracle::Outcome Oracle::carryOut(core::ReadCodes& command)
{
    const core::VoxelBox& box = command.box;
    if (box.empty() || !m_codes.contains(box.minimum) || !m_codes.contains(box.maximum - 1))
        return refuse("box", "is empty or not within the volume");
    core::EngineResult result;
    for (int z = box.minimum.z; z < box.maximum.z; ++z)
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                result.codes.push_back(m_codes.at({x, y, z}));
    return result;
}

Oracle::Outcome Oracle::carryOut(core::ReadBarriers& command)
{
    const DenseArray<std::uint32_t>& words = m_fields.seedWords(command.plane);
    const core::BrickGrid grid{words.size};
    core::EngineResult result;
    for (int brick = 0; brick < grid.brickCount(); ++brick) {
        const core::VoxelBox box = grid.boxOf(brick);
        bool holds = false;
        for (int z = box.minimum.z; z < box.maximum.z; ++z)
            for (int y = box.minimum.y; y < box.maximum.y; ++y)
                for (int x = box.minimum.x; x < box.maximum.x; ++x)
                    holds = holds || words.at({x, y, z}) == core::seedWord::barrier;
        const core::BrickKey key{core::Field::SeedWords, command.plane, std::uint32_t(brick)};
        if (holds)
            result.changes.push_back({key, {}, m_fields.readBrick(key)});
    }
    return result;
}

Oracle::Outcome Oracle::carryOut(core::ProbeVoxels& command)
{
    core::EngineResult result;
    for (const glm::ivec3& voxel : command.voxels) {
        if (!m_codes.contains(voxel))
            return refuse("voxels", "outside the volume");
        const std::uint32_t word = m_fields.seedWords(command.plane).at(voxel);
        core::ProbedVoxel probe{.code = m_codes.at(voxel),
            .label = m_fields.labels(command.plane).at(voxel),
            .seedOf =
                std::uint8_t(core::seedWord::isPendingSeed(word) ? core::seedWord::label(word) : 0),
            .tolerance = m_tolerance ? m_tolerance->at(voxel) : std::nullopt};
        for (const auto& [plane, labels] : m_fields.labelPlanes()) {
            if (plane < probe.labels.size())
                probe.labels[plane] = labels->at(voxel);
        }
        result.probes.push_back(probe);
    }
    return result;
}

Oracle::Outcome Oracle::carryOut(core::ProbeSeeds& command)
{
    if (const core::Result<void> checked = checkGroups(command.seedGroups); !checked)
        return tl::unexpected(checked.error());
    const core::GroupedSeedSums sums =
        seedSums(m_codes, m_fields.seedWords(command.plane), command);
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

Oracle::Outcome Oracle::carryOut(core::PickVoxels& command)
{
    if (command.seenBy == core::SeenBy::Opacity && command.opacityOfCode.size() != 256)
        return refuse("opacityOfCode", "has 256 entries");
    core::EngineResult result;
    if (command.seenBy == core::SeenBy::Segment) {
        std::vector<const DenseArray<std::uint8_t>*> planes;
        for (const auto& [plane, labels] : m_fields.labelPlanes())
            planes.push_back(labels);
        for (const core::PickRay& ray : command.rays)
            result.picks.push_back(pickSegment(planes, command, ray));
        return result;
    }
    const DenseArray<std::uint8_t> seen = carved();
    for (const core::PickRay& ray : command.rays)
        result.picks.push_back(pick({m_codes, seen}, command, ray));
    return result;
}

Oracle::Outcome Oracle::carryOut(core::CountGenerations& command)
{
    core::EngineResult result;
    for (const std::uint32_t word : m_fields.seedWords(command.plane).values) {
        if (!core::seedWord::isMember(word))
            continue;
        const std::size_t generation = core::seedWord::generation(word);
        result.generationSizes.resize(std::max(result.generationSizes.size(), generation + 1));
        ++result.generationSizes[generation];
    }
    return result;
}

Oracle::Outcome Oracle::carryOut(core::TraceTolerance& command)
{
    if (m_open)
        return refuse("transaction", "an edit is open");
    m_tolerance.reset();
    auto traced =
        traceTolerance(m_codes, m_fields.composedCoverage(m_muted), m_fields, command.rule);
    if (!traced)
        return tl::unexpected(traced.error());
    m_tolerance = std::move(*traced);
    core::EngineResult result;
    result.tolerance = m_tolerance->curve;
    return result;
}

Oracle::Outcome Oracle::carryOut(core::DropTolerance&)
{
    m_tolerance.reset();
    return core::EngineResult{};
}

Oracle::Outcome Oracle::carryOut(core::PreviewCut& command)
{
    if (m_open)
        return refuse("transaction", "an edit is open");
    if (const core::Result<void> checked = checkCut(command.cut); !checked)
        return tl::unexpected(checked.error());
    core::EngineResult result;
    const core::Result<core::CutPreview> cutPreview = previewCut(m_fields, command.cut);
    if (!cutPreview)
        return tl::unexpected(cutPreview.error());
    result.cutPreview = *cutPreview;
    return result;
}

Oracle::Outcome Oracle::carryOut(core::DropCutPreview&)
{
    return core::EngineResult{};
}

Oracle::Outcome Oracle::carryOut(core::CompareGrowth&)
{
    const Growth* growth = m_open ? std::get_if<Growth>(&m_open->work) : nullptr;
    if (!growth)
        return refuse("transaction", "no growth is open");
    const std::uint8_t plane = growth->plane();
    const std::vector<std::uint8_t>& before = m_open->before.labels(plane).values;
    const std::vector<std::uint8_t>& now = m_fields.labels(plane).values;
    const std::vector<std::uint32_t>& words = m_fields.seedWords(plane).values;
    core::GrowthComparison comparison;
    for (std::size_t voxel = 0; voxel < now.size(); ++voxel) {
        if (before[voxel] == now[voxel])
            continue;
        const bool isMember = core::seedWord::isMember(words[voxel]);
        ++(isMember ? comparison.reached : comparison.suspended);
    }
    core::EngineResult result;
    result.growthComparison = comparison;
    return result;
}

} // namespace reference

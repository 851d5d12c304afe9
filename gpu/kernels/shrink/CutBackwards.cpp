// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/shrink/CutBackwards.h"

#include "gpu/kernels/shrink/CutGrown.h"

#include <utility>

namespace gpu {

CutBackwards::CutBackwards(VoxelFields& fields, BeforeImages& before, std::uint8_t plane)
    : m_fields(fields)
    , m_before(before)
    , m_plane(plane)
    , m_words(readWords(fields, plane))
{
}

core::Result<std::unique_ptr<CutBackwards>> CutBackwards::begin(
    VoxelFields& fields, BeforeImages& before, const core::CutGrowth& command)
{
    std::unique_ptr<CutBackwards> begun(new CutBackwards(fields, before, command.plane));
    auto cut = core::BackwardCut::begin(begun->m_words, command);
    if (!cut)
        return tl::unexpected(cut.error());
    begun->m_cut = *std::move(cut);
    begun->write();
    return begun;
}

void CutBackwards::advanceTo(std::uint32_t steps)
{
    const std::uint32_t before = m_cut->progress().steps;
    m_cut->advanceTo(steps);
    if (m_cut->progress().steps != before)
        write();
}

void CutBackwards::write()
{
    core::GrowthCutOutcome outcome = m_cut->outcome();
    m_generation = outcome.generation;
    std::map<std::uint32_t, core::CutBrick> now;
    std::vector<core::CutBrick> changed;
    for (core::CutBrick& brick : outcome.bricks) {
        const auto known = m_written.find(brick.brick);
        if (known == m_written.end() || known->second.words != brick.words
            || known->second.leaving != brick.leaving)
            changed.push_back(brick);
        const std::uint32_t number = brick.brick;
        now.emplace(number, std::move(brick));
    }
    // Where only the barrier of an earlier step stood, the words are again what they were.
    std::vector<core::BrickKey> left;
    for (const auto& [number, brick] : m_written) {
        if (now.count(number) == 0)
            left.push_back({.field = core::Field::SeedWords, .plane = m_plane, .brick = number});
    }
    m_before.restore(std::move(left));
    for (const core::BrickKey& key : writeCut(m_fields, m_before, m_plane, changed))
        m_touched.insert(key);
    m_written = std::move(now);
}

} // namespace gpu

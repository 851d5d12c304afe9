// SPDX-License-Identifier: Apache-2.0
#include "core/growth/LeakGuard.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <bit>

namespace core {

namespace {

constexpr std::uint32_t fresh = 0xFFFFFFFFu; ///< of this generation, and in no front yet

/// Along which axes a neighbour is away: bit 0: x, 1: y, 2: z.
std::uint32_t axesOf(const std::array<int, 3>& offset)
{
    return (offset[0] ? 1u : 0u) | (offset[1] ? 2u : 0u) | (offset[2] ? 4u : 0u);
}

} // namespace

LeakGuard::LeakGuard(const BrickGrid& grid, const GuardRule& rule)
    : m_grid(grid)
    , m_rule(rule)
    , m_ids(std::size_t(grid.brickCount()))
{
}

LeakGuard::~LeakGuard() = default;

std::uint32_t* LeakGuard::ids(std::uint32_t brick)
{
    std::unique_ptr<std::uint32_t[]>& page = m_ids[brick];
    if (!page)
        page = std::make_unique<std::uint32_t[]>(BrickGrid::voxelsPerBrick);
    return page.get();
}

LeakGuard::Front* LeakGuard::touched(std::uint32_t id)
{
    const bool known = id >= m_firstOfLast && id - m_firstOfLast < m_last.size();
    return known ? &m_last[id - m_firstOfLast] : nullptr;
}

LeakGuard::Front LeakGuard::flood(Voxel start, std::uint32_t id)
{
    Front front;
    front.least = start;
    const Front* trunk = nullptr;
    std::vector<Voxel> open{start};
    ids(start.brick)[start.offset] = id;
    std::int64_t area = 0;
    while (!open.empty()) {
        const Voxel voxel = open.back();
        open.pop_back();
        ++front.voxels;
        front.least = std::min(front.least, voxel);
        const glm::ivec3 place = voxel.place(m_grid);
        std::array<std::uint32_t, 4> axes{}; // by how many of them a neighbour is away
        for (const std::array<int, 3>& offset : seedWord::offsets) {
            const glm::ivec3 next = place + glm::ivec3(offset[0], offset[1], offset[2]);
            if (glm::any(glm::lessThan(next, glm::ivec3(0)))
                || glm::any(glm::greaterThanEqual(next, m_grid.volumeSize)))
                continue;
            const Voxel there = Voxel::of(m_grid, next);
            if (!m_ids[there.brick])
                continue;
            std::uint32_t& nextId = m_ids[there.brick][there.offset];
            if (nextId == fresh) {
                nextId = id;
                open.push_back(there);
            } else if (const Front* before = touched(nextId)) {
                const std::uint32_t along = axesOf(offset);
                axes[std::size_t(std::popcount(along))] |= along;
                const bool wins = !trunk || before->own.size > trunk->own.size
                    || (before->own.size == trunk->own.size && before->least < trunk->least);
                trunk = wins ? before : trunk;
            }
        }
        if (m_rule.measure)
            area += m_rule.measure->areaUm2[axes[1] ? axes[1] : axes[2] ? axes[2] : axes[3]];
    }
    front.own = m_rule.measure ? Past{.size = area,
                    .thickness = std::max<std::int64_t>(
                        m_rule.measure->volumeUm3 / (area / front.voxels), 1)}
                               : Past{.size = front.voxels, .thickness = 1};
    follow(front, trunk);
    return front;
}

std::optional<LeakAlarm> LeakGuard::look(std::uint32_t generation, std::span<const Voxel> voxels)
{
    for (const Voxel voxel : voxels)
        ids(voxel.brick)[voxel.offset] = fresh;
    std::vector<Front> fronts;
    const std::uint32_t firstId = m_firstOfLast + std::uint32_t(m_last.size());
    for (const Voxel start : voxels) {
        if (ids(start.brick)[start.offset] == fresh)
            fronts.push_back(flood(start, firstId + std::uint32_t(fronts.size())));
    }
    m_last = std::move(fronts);
    m_firstOfLast = firstId;

    const Front* worst = nullptr;
    for (const Front& front : m_last) {
        if (narrowPlace(front) == 0)
            continue;
        if (!worst || front.own.size > worst->own.size
            || (front.own.size == worst->own.size && front.least < worst->least))
            worst = &front;
    }
    if (!worst)
        return std::nullopt;
    return LeakAlarm{.generation = generation,
        .narrow = generation - std::uint32_t(narrowPlace(*worst)),
        .voxels = worst->voxels,
        .areaUm2 = m_rule.measure ? worst->own.size : 0,
        .voxel = worst->least.place(m_grid)};
}

void LeakGuard::follow(Front& front, const Front* trunk) const
{
    if (!trunk)
        return;
    front.widestBefore = trunk->widestBefore;
    front.trunk.reserve(trunk->trunk.size() + 1);
    front.trunk.push_back(trunk->own);
    // What lies further back than a narrow place and what is looked for before it is summed up.
    std::int64_t back = front.own.thickness; // to the one before `past`
    std::int64_t further = trunk->own.thickness;
    for (std::size_t i = 0; i < trunk->trunk.size(); ++i) {
        const Past& past = trunk->trunk[i];
        const bool far = back >= 2 * m_rule.window || i + 1 >= 2 * std::size_t(mostBack);
        if (far)
            front.widestBefore = std::max(front.widestBefore, past.size);
        else
            front.trunk.push_back(past);
        back += further;
        further = past.thickness;
    }
}

int LeakGuard::narrowPlace(const Front& front) const
{
    const auto known = front.trunk.size();
    std::int64_t back = front.own.thickness; // d(k)
    for (std::size_t i = 0; i < known && int(i) < mostBack && back <= m_rule.window; ++i) {
        const std::int64_t narrow = front.trunk[i].size;
        if (256 * front.own.size >= m_rule.factor256 * narrow
            && front.own.size >= narrow + m_rule.excess
            && (wasWider(front, i) || wasAsNarrow(front, i)))
            return int(i) + 1;
        back += front.trunk[i].thickness;
    }
    return 0;
}

bool LeakGuard::wasWider(const Front& front, std::size_t at)
{
    const std::int64_t narrow = front.trunk[at].size;
    const auto wider = [narrow](std::int64_t size) { return 2 * size >= 3 * narrow; };
    return wider(front.widestBefore)
        || std::any_of(front.trunk.begin() + std::ptrdiff_t(at) + 1, front.trunk.end(),
            [&wider](const Past& past) { return wider(past.size); });
}

bool LeakGuard::wasAsNarrow(const Front& front, std::size_t at) const
{
    const std::int64_t narrow = front.trunk[at].size;
    std::int64_t back = front.trunk[at].thickness; // d(j) − d(k)
    for (std::size_t j = at + 1; j < front.trunk.size() && j <= at + std::size_t(mostBack); ++j) {
        const std::int64_t size = front.trunk[j].size;
        if (2 * size < narrow || 2 * size > 3 * narrow)
            return false;
        if (back >= m_rule.window)
            return true;
        back += front.trunk[j].thickness;
    }
    return false;
}

} // namespace core

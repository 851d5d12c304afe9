// SPDX-License-Identifier: Apache-2.0
#include "core/growth/LeakGuard.h"

#include "core/growth/SeedWord.h"

#include <algorithm>

namespace core {

namespace {

constexpr std::uint32_t fresh = 0xFFFFFFFFu; ///< of this generation, and in no front yet

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

glm::ivec3 LeakGuard::placeOf(Voxel voxel) const
{
    return m_grid.brickPosition(int(voxel >> 12)) * BrickGrid::side
        + glm::ivec3(int(voxel & 15u), int(voxel >> 4 & 15u), int(voxel >> 8 & 15u));
}

LeakGuard::Front* LeakGuard::touched(std::uint32_t id)
{
    const bool known = id >= m_firstOfLast && id - m_firstOfLast < m_last.size();
    return known ? &m_last[id - m_firstOfLast] : nullptr;
}

std::optional<LeakAlarm> LeakGuard::look(std::uint32_t generation, std::span<const Voxel> voxels)
{
    for (const Voxel voxel : voxels)
        ids(voxel >> 12)[voxel & 4095u] = fresh;
    std::vector<Front> fronts;
    std::vector<Voxel> open;
    const std::uint32_t firstId = m_firstOfLast + std::uint32_t(m_last.size());
    for (const Voxel start : voxels) {
        std::uint32_t& startId = ids(start >> 12)[start & 4095u];
        if (startId != fresh)
            continue;
        const std::uint32_t id = firstId + std::uint32_t(fronts.size());
        startId = id;
        open.assign(1, start);
        Front front;
        front.least = start;
        const Front* trunk = nullptr;
        while (!open.empty()) {
            const Voxel voxel = open.back();
            open.pop_back();
            ++front.size;
            front.least = std::min(front.least, voxel);
            const glm::ivec3 place = placeOf(voxel);
            for (const std::array<int, 3>& offset : seedWord::offsets) {
                const glm::ivec3 next = place + glm::ivec3(offset[0], offset[1], offset[2]);
                if (glm::any(glm::lessThan(next, glm::ivec3(0)))
                    || glm::any(glm::greaterThanEqual(next, m_grid.volumeSize)))
                    continue;
                const auto brick = std::uint32_t(m_grid.brickOf(next));
                if (!m_ids[brick])
                    continue;
                const auto at = std::uint32_t(BrickGrid::offsetInBrick(next));
                std::uint32_t& nextId = m_ids[brick][at];
                if (nextId == fresh) {
                    nextId = id;
                    open.push_back(brick << 12 | at);
                } else if (const Front* before = touched(nextId); before && before != trunk) {
                    const bool wins = !trunk || before->size > trunk->size
                        || (before->size == trunk->size && before->least < trunk->least);
                    trunk = wins ? before : trunk;
                }
            }
        }
        follow(front, trunk);
        fronts.push_back(std::move(front));
    }
    m_last = std::move(fronts);
    m_firstOfLast = firstId;

    const Front* worst = nullptr;
    for (const Front& front : m_last) {
        if (narrowPlace(front) == 0)
            continue;
        if (!worst || front.size > worst->size
            || (front.size == worst->size && front.least < worst->least))
            worst = &front;
    }
    if (!worst)
        return std::nullopt;
    return LeakAlarm{.generation = generation,
        .narrow = generation - std::uint32_t(narrowPlace(*worst)),
        .voxels = worst->size,
        .voxel = placeOf(worst->least)};
}

void LeakGuard::follow(Front& front, const Front* trunk) const
{
    if (!trunk)
        return;
    front.trunk.reserve(trunk->trunk.size() + 1);
    front.trunk.push_back(trunk->size);
    front.trunk.insert(front.trunk.end(), trunk->trunk.begin(), trunk->trunk.end());
    front.widestBefore = trunk->widestBefore;
    if (front.trunk.size() > 2 * std::size_t(m_rule.window)) {
        front.widestBefore = std::max(front.widestBefore, front.trunk.back());
        front.trunk.pop_back();
    }
}

int LeakGuard::narrowPlace(const Front& front) const
{
    const int known = int(front.trunk.size());
    for (int k = 1; k <= std::min(m_rule.window, known); ++k) {
        const std::int64_t narrow = front.trunk[std::size_t(k - 1)];
        if (256 * front.size < m_rule.factor256 * narrow || front.size < narrow + m_rule.excess)
            continue;
        const auto wider = [narrow](std::int64_t size) { return 2 * size >= 3 * narrow; };
        const auto within = [narrow](std::int64_t size) {
            return narrow <= 2 * size && 2 * size <= 3 * narrow;
        };
        const auto earlier = front.trunk.begin() + k;
        if (wider(front.widestBefore) || std::any_of(earlier, front.trunk.end(), wider))
            return k;
        if (known >= k + m_rule.window && std::all_of(earlier, earlier + m_rule.window, within))
            return k;
    }
    return 0;
}

} // namespace core

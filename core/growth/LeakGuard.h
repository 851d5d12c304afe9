// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/growth/GrowthCommands.h"

#include <memory>
#include <span>
#include <vector>

namespace core {

/// Watches the fronts of one burst of growth (GuardRule). Whole numbers, so that it alarms at the
/// same generation everywhere. What grew before the burst is not looked at.
///
/// 1. A front is a set of voxels that one generation of the burst added and that hang together over
///    26 neighbours, whichever their labels; its size is how many they are.
/// 2. The trunk of a front is, of the fronts of the generation before that a voxel of it touches
///    (26 neighbours), the largest, of equals the one that holds the least voxel (its brick, then
///    its offset there). The trunk's trunk and so on lead back to the beginning; s(1), s(2), … are
///    the sizes on that way, s(0) is the front's own.
/// 3. A narrow place is a k from 1 to `window` with s(0) ≥ factor · s(k) and s(0) ≥ s(k) + excess,
///    where growth had been wider before, s(j) ≥ 3/2 s(k) for some j > k, or had been as narrow
///    for long: 1/2 s(k) ≤ s(j) ≤ 3/2 s(k) for all j from k + 1 to k + window, and they are there.
///    (A front that has only ever widened, out of a tip or corner, has none.)
/// 4. A generation alarms if one of its fronts has a narrow place. The alarm names the largest of
///    these fronts, of equals the one with the least voxel, that voxel, and its least k.
class LeakGuard {
public:
    LeakGuard(const BrickGrid& grid, const GuardRule& rule);
    ~LeakGuard();

    /// A voxel: its brick << 12 | its offset there.
    using Voxel = std::uint32_t;
    /// To be told every generation of the burst. Cost ∝ the voxels.
    [[nodiscard]] std::optional<LeakAlarm> look(
        std::uint32_t generation, std::span<const Voxel> voxels);

private:
    struct Front {
        Voxel least = 0;
        std::int64_t size = 0;
        std::vector<std::int64_t> trunk; ///< s(1) first, 2 · window of them at most
        std::int64_t widestBefore = 0; ///< of the trunk's sizes that are left out
    };

    [[nodiscard]] std::uint32_t* ids(std::uint32_t brick);
    [[nodiscard]] Front* touched(std::uint32_t id);
    void follow(Front& front, const Front* trunk) const;
    [[nodiscard]] int narrowPlace(const Front& front) const;
    [[nodiscard]] glm::ivec3 placeOf(Voxel voxel) const;

    BrickGrid m_grid;
    GuardRule m_rule;
    /// Of each voxel of a brick that was touched the number of its front; fronts are numbered on.
    std::vector<std::unique_ptr<std::uint32_t[]>> m_ids;
    std::vector<Front> m_last; ///< of the generation before
    std::uint32_t m_firstOfLast = 1;
};

} // namespace core

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
///    26 neighbours, whichever their labels.
/// 2. The axes of a voxel of it are those along which lie its face neighbours that the generation
///    before added; where there are none, its edge neighbours; then its corner neighbours; then
///    none. A voxel's area is FrontMeasure::areaUm2 of its axes: that of its faces as the sides of
///    a plane that cuts off a corner, so that flat fronts, slanting ones and those of a growth from
///    a point have the area that they have, whatever the spacing.
/// 3. A front's size is the sum of these areas. Its thickness t is volumeUm3 over its mean area,
/// both
///    divisions rounded down, and at least 1. Without a measure its size is the number of its
///    voxels, and t = 1.
/// 4. The trunk of a front is, of the fronts of the generation before that a voxel of it touches
///    (26 neighbours), the largest, of equals the one that holds the least voxel (its brick, then
///    its offset there). The trunk's trunk and so on lead back to the beginning; s(1), s(2), … are
///    the sizes on that way, s(0) is the front's own; so t(0), t(1), …. From j it is
///    d(j) = t(0) + … + t(j − 1) back to the front.
/// 5. A narrow place is a k from 1 to `mostBack` with d(k) ≤ `window`, s(0) ≥ factor · s(k) and
///    s(0) ≥ s(k) + excess, where growth had been wider before, s(j) ≥ 3/2 s(k) for some j > k, or
///    had been as narrow for long: with l the least j > k with d(j) − d(k) ≥ window,
///    1/2 s(k) ≤ s(j) ≤ 3/2 s(k) for all j from k + 1 to l, l ≤ k + `mostBack`, and they are there.
///    (A front that has only ever widened, out of a tip or corner, has none.)
/// 6. A generation alarms if one of its fronts has a narrow place. The alarm names the largest of
///    these fronts, of equals the one with the least voxel, that voxel, and its least k.
class LeakGuard {
public:
    LeakGuard(const BrickGrid& grid, const GuardRule& rule);
    ~LeakGuard();

    static constexpr int mostBack = 1000; ///< fronts

    /// A voxel: its brick << 12 | its offset there.
    using Voxel = std::uint32_t;
    /// To be told every generation of the burst. Cost ∝ the voxels.
    [[nodiscard]] std::optional<LeakAlarm> look(
        std::uint32_t generation, std::span<const Voxel> voxels);

private:
    /// A front as those that come after it remember it.
    struct Past {
        std::int64_t size = 0;
        std::int64_t thickness = 0;
    };
    struct Front {
        Voxel least = 0;
        std::int64_t voxels = 0;
        Past own;
        std::vector<Past> trunk; ///< that of 1 first, as far back as a narrow place is looked for
        std::int64_t widestBefore = 0; ///< of the trunk's sizes that are left out
    };

    [[nodiscard]] std::uint32_t* ids(std::uint32_t brick);
    [[nodiscard]] Front* touched(std::uint32_t id);
    /// A front's voxels, from one of them on.
    [[nodiscard]] Front flood(Voxel start, std::uint32_t id);
    void follow(Front& front, const Front* trunk) const;
    [[nodiscard]] int narrowPlace(const Front& front) const;
    // Whether before a place of the trunk (0: s(1)) growth was wider; was as narrow for long.
    [[nodiscard]] static bool wasWider(const Front& front, std::size_t at);
    [[nodiscard]] bool wasAsNarrow(const Front& front, std::size_t at) const;
    [[nodiscard]] glm::ivec3 placeOf(Voxel voxel) const;

    BrickGrid m_grid;
    GuardRule m_rule;
    /// Of each voxel of a brick that was touched the number of its front; fronts are numbered on.
    std::vector<std::unique_ptr<std::uint32_t[]>> m_ids;
    std::vector<Front> m_last; ///< of the generation before
    std::uint32_t m_firstOfLast = 1;
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickVoxel.h"
#include "core/growth/GrowthCommands.h"

#include <memory>
#include <span>
#include <vector>

namespace core {

/// Finds out whether a growth has leaked, by watching the fronts of one burst (GuardRule). It
/// computes in whole numbers, so that the alarm comes at the same generation on every machine. What
/// grew before the burst is not examined.
///
/// 1. A front is a connected set (26 neighbours) of voxels that one generation of the burst added,
///    whatever their labels.
/// 2. The axes of a voxel of a front are those along which its face neighbours of the generation
///    before lie; if it has none, its edge neighbours; if it has none, its corner neighbours;
///    otherwise it has no axes. FrontMeasure::areaUm2 of these axes is the voxel's area: that of
///    its faces as the sides of a plane that cuts off a corner. So flat and slanting fronts and
///    those of a growth from a point have their true areas, whatever the spacing.
/// 3. The size of a front is the sum of the areas of its voxels. Its thickness t is volumeUm3
///    divided by their mean area, both divisions rounded down, and at least 1. Without a measure
///    the size is the number of voxels and t = 1.
/// 4. The trunk of a front is the largest of those fronts of the generation before that one of its
///    voxels touches (26 neighbours); of equally large ones it is the front that holds the least
///    voxel (by brick, then by offset in the brick). Following trunks leads back to the beginning.
///    s(0), s(1), s(2), … are the sizes on that path from the front itself on, t(0), t(1), … the
///    thicknesses. The distance from the j-th of them to the front is
///    d(j) = t(0) + … + t(j − 1).
/// 5. A narrow place is a k from 1 to `mostBack` for which d(k) ≤ window, s(0) ≥ factor · s(k),
///    s(0) ≥ s(k) + excess, and one of these holds:
///    - growth was wider before: s(j) ≥ 3/2 s(k) for some j > k;
///    - growth was as narrow for long: let l be the least j > k with d(j) − d(k) ≥ window; l
///      exists, l ≤ k + `mostBack`, and 1/2 s(k) ≤ s(j) ≤ 3/2 s(k) for all j from k + 1 to l.
///    (A front that only ever widened, from a tip or a corner, has no narrow place.)
/// 6. A generation raises the alarm if one of its fronts has a narrow place. The alarm reports the
///    largest of these fronts (of equally large ones the one with the least voxel), that least
///    voxel, and the least k of the front.
class LeakGuard {
public:
    LeakGuard(const BrickGrid& grid, const GuardRule& rule);
    ~LeakGuard();

    static constexpr int mostBack = 1000; ///< fronts

    using Voxel = BrickVoxel;
    /// To be called for every generation of the burst, in order. Cost ∝ the number of voxels.
    [[nodiscard]] std::optional<LeakAlarm> look(
        std::uint32_t generation, std::span<const Voxel> voxels);

private:
    /// What later fronts remember of a front.
    struct Past {
        std::int64_t size = 0;
        std::int64_t thickness = 0;
    };
    struct Front {
        Voxel least;
        std::int64_t voxels = 0;
        Past own;
        std::vector<Past> trunk; ///< nearest first, as far back as narrow places are searched for
        std::int64_t widestBefore = 0; ///< the greatest size on the trunk farther back
    };

    [[nodiscard]] std::uint32_t* ids(std::uint32_t brick);
    [[nodiscard]] Front* touched(std::uint32_t id);
    /// Collects the voxels of a front from one of them.
    [[nodiscard]] Front flood(Voxel start, std::uint32_t id);
    void follow(Front& front, const Front* trunk) const;
    [[nodiscard]] int narrowPlace(const Front& front) const;
    // Rule 5 for a place of the trunk (0: s(1)).
    [[nodiscard]] static bool wasWider(const Front& front, std::size_t at);
    [[nodiscard]] bool wasAsNarrow(const Front& front, std::size_t at) const;

    BrickGrid m_grid;
    GuardRule m_rule;
    /// For each brick that was touched, the front number of each voxel; numbers are not reused.
    std::vector<std::unique_ptr<std::uint32_t[]>> m_ids;
    std::vector<Front> m_last; ///< fronts of the generation before
    std::uint32_t m_firstOfLast = 1;
};

} // namespace core

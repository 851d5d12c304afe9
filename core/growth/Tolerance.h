// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"

#include <bitset>
#include <cstdint>
#include <vector>

namespace core {

/// The least tolerance at which each voxel would join a segment that grows from its seeds, in
/// integers. Both engines follow the rule to the bit.
///
/// Seeds: the pending seeds of the label, its members that are seeds (SeedWord.h), and those of
/// generation 0: they are painted. Centre: ⌊(2 · Σ code + n) / (2 · n)⌋ over the n of them.
/// Open: what is painted; and every voxel that is neither a barrier nor a member of another label,
/// at which the plane holds 0, the label or a label in `overwritable`, and which the limits allow
/// (GrowLimits; those of them that a ToleranceRule may have).
/// Cost of an open voxel: 0 if it is painted, else |code − centre|. A path begins with an open seed
/// and goes on through open voxels, each a neighbour of the last (`connectivity` as GrowBurst's);
/// its tolerance is the greatest cost on it, the seed's included. That of a voxel is the least of
/// all paths that lead there; none where none leads, or none of `greatest` or less.
///
/// So the voxels of tolerance ≤ t are the members that the label would have after a GrowBurst from
/// its seeds (GrowOpening::Restart) to closure, of the interval centre − t … centre + t and with
/// this rule's neighbours, limits and `overwritable`, if every other label were frozen and
/// generations had no end.
struct ToleranceRule {
    static constexpr int greatest = 65533; ///< a field has two values for none

    std::uint8_t plane = 0;
    std::uint8_t label = 0; ///< not 0
    int connectivity = 6; ///< 6, 18 or 26
    /// Only `gradient`, `onlyVisible` and the box: what depends on the interval or on the voxel
    /// before knows no least tolerance.
    GrowLimits limits{};
    std::bitset<256> overwritable{};
    bool operator==(const ToleranceRule&) const = default;
};

/// Whether an engine may take it: every number in its range, no limit but those named.
[[nodiscard]] bool isSound(const ToleranceRule& rule);

/// How a segment grows with the tolerance.
struct ToleranceCurve {
    int centre = 0; ///< code
    /// Place t: how many voxels have tolerance t; ends with the last that has any.
    std::vector<std::uint32_t> sizes{};
    bool operator==(const ToleranceCurve&) const = default;
};

/// Place t: how many voxels have tolerance t or less.
[[nodiscard]] std::vector<std::int64_t> membersOf(const ToleranceCurve& curve);

/// Where a segment suddenly becomes much greater: most likely it leaks there.
///
/// Tolerances are walked in steps of one code, or of a 4096th of the greatest where that is more. A
/// step is a jump if after it there are more than `factor256` 256ths of the members before it, and
/// `leastVoxels` more at least. Told are the tolerances at which jumps end.
struct JumpRule {
    int factor256 = 384; ///< half as many again
    std::int64_t leastVoxels = 500;
};
[[nodiscard]] std::vector<int> jumpsOf(
    const std::vector<std::int64_t>& members, const JumpRule& rule = {});

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"

#include <bitset>
#include <cstdint>
#include <vector>

namespace core {

/// The tolerance field: for each voxel, the least tolerance around the mean of the seeds at which
/// it would join a segment that grows from them. All numbers are integers, and both engines follow
/// this rule exactly.
///
/// Seeds: the pending seeds of the label, its members that are seeds (SeedWord.h), and its members
///   of generation 0, which were painted. The centre is ⌊(2 · Σ code + n) / (2 · n)⌋ over these n.
/// Open voxels: what is painted; and every voxel that is neither a barrier nor a member of another
///   label, at which the plane holds 0, the label or a label in `overwritable`, which the limits
///   allow (GrowLimits; only some may be set, see below), and which is among the voxels of `range`.
/// Cost of an open voxel: 0 if it is painted, otherwise |code − centre|.
/// Paths: a path begins with an open seed and continues through open voxels, each a neighbour of
///   the one before (`connectivity` as in GrowBurst). Its tolerance is the greatest cost on it,
///   including the seed's. The tolerance of a voxel is the least over all paths that lead to it;
///   it has none if no path does, or none with a tolerance of `greatest` or less.
///
/// So the voxels of tolerance ≤ t are those that the label would have after a GrowBurst from its
/// seeds (GrowOpening::Restart) to closure with the interval centre − t … centre + t and with the
/// neighbours, limits, `overwritable` and `range` of this rule, if every other label were locked
/// and there were no greatest generation.
struct ToleranceRule {
    static constexpr int greatest = 65533; ///< a field has two more values, which mean none

    std::uint8_t plane = 0;
    std::uint8_t label = 0; ///< not 0
    int connectivity = 6; ///< 6, 18 or 26
    /// Only `gradient`, `onlyVisible` and the box may be set: with conditions that depend on the
    /// interval or on the parent there is no least tolerance, and costs are those of codes, not of
    /// medians.
    GrowLimits limits{};
    std::bitset<256> overwritable{};
    GrowthRange range{};
    bool operator==(const ToleranceRule&) const = default;
};

/// Whether an engine may accept it: every number is in range, and no other limit is set.
[[nodiscard]] bool isSound(const ToleranceRule& rule);

/// How a segment grows with the tolerance: a histogram of tolerances.
struct ToleranceCurve {
    int centre = 0; ///< code; the mean of the seeds
    /// At index t: how many voxels have tolerance t. It ends with the greatest that occurs.
    std::vector<std::uint32_t> sizes{};
    bool operator==(const ToleranceCurve&) const = default;
};

/// At index t: how many voxels have tolerance t or less.
[[nodiscard]] std::vector<std::int64_t> membersOf(const ToleranceCurve& curve);

/// Where a segment suddenly becomes much larger, most likely because it leaks there.
///
/// Tolerances are compared in steps of one code, or of a 4096th of the greatest tolerance where
/// that is more. A step is a jump if the members after it are more than `factor256` 256ths of those
/// before it and at least `leastVoxels` more. jumpsOf() returns the tolerances at which jumps end.
struct JumpRule {
    int factor256 = 384; ///< more than one and a half times as many
    std::int64_t leastVoxels = 500;
};
[[nodiscard]] std::vector<int> jumpsOf(
    const std::vector<std::int64_t>& members, const JumpRule& rule = {});

} // namespace core

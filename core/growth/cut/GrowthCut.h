// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/WordBricks.h"

#include <map>

namespace core {

// What CutGrowth takes away. It is found for each label that is not frozen by itself, the lowest
// first; "members" are those of the label, "neighbours" all 26. Everything is a whole number, and
// nothing depends on an order.
//
// 1. The sketch is the members among the voxels named. Where a root (rule 2) is among them, of any
//    label that is not frozen, the cut is refused: ErrorCode::SeedsStay. So it is where there is no
//    sketch of any label: ErrorCode::NothingGrown.
// 2. Roots are the members that are seeds or of generation 0; they have no parents. The parents of
//    any other member are the members of an earlier generation among its neighbours over faces; if
//    its direction is 6 or more, over edges too; if it is 18 or more, over corners too. (In place
//    of 29 stands the lowest direction that leads from a member of an earlier generation.)
// 3. A front is a set of members of one generation that hang together by neighbours of the first
//    `connectivity` directions.
// 4. The way consists of the fronts that hold a voxel of the sketch and, again and again, of the
//    fronts that hold a parent of a voxel of the way. w(n) of its voxels are of generation n.
// 5. Beyond lie the fronts that hold a voxel of the sketch and, again and again, the members that
//    have a parent there. b(n) of these are of generation n.
// 6. For a generation n on the way (w(n) > 0) let
//        q(n) = min(greatest w(m), m < n; greatest of w(m) and b(m), m > n) / w(n).
//    Necks are the generations with q(n) ≥ 3/2 that have the greatest q of all, of equals the
//    lowest, or at least half of that, w(m) > w(n) or 0 for m = n − 4 … n − 1 and w(m) ≥ w(n) or 0
//    for m = n + 1 … n + 4. N: the way's voxels of such a generation.
// 7. Behind a set of members lie those of it that are no roots, and every member that has parents
//    when all of them lie behind it.
// 8. For each neck a cut is made. It is N, if that is more than `widestPassage` voxels; else it is
//    put where the passage is narrowest near N. Let D be what lies behind N. Let the
//    surroundings be the members that can be reached from N in at most r steps to neighbours, with
//    r = 2 + the longest side of N's box in voxels, at most `farthestPassage`. Of these, sources
//    are those outside D that are r steps away, or roots; sinks are those in D that are r steps
//    away, or of a generation from the lowest m > n on at which w(m) or b(m) is as great as the
//    numerator of q(n). The cut is the smallest set of voxels of the surroundings without which no
//    way over neighbours leads from a source to a sink (both may be in it); of such sets the one
//    nearest to the sources: what is reached from them is the least. Where there is
//    no source or no sink, or a root is in it, the cut is N.
//    Only cuts count that all of the sketch lies behind. Of them that of the fewest voxels is
//    taken, of equals that of the lowest n.
// 9. What leaves, How by How. No root ever does.
//    Neck: what lies behind the cut, however near to the roots; nothing where there is no cut.
//    Subtree: of what lies behind the cut and the sketch together (without a cut: behind the
//      sketch), the sketch and all that is no nearer to the roots than to the sketch. Distances
//      are steps over members, from one to its neighbours in the first K directions, K being the
//      most that the parents of a member of the label are looked for in (rule 2): 6, 18 or 26.
//      What is reached from neither leaves.
//    Here: the sketch.
// 10. Of what lies behind the cut and the sketch (Here: behind the sketch), what stays may have
//    lost its parents. t(v) of such a voxel is the least number that is not below its generation
//    and above that, or t, of a neighbour in the first K directions that stays. Where t(v) is
//    another generation, or no parent of v stays with an earlier one, the word becomes
//    member(t(v), label, the lowest direction below K that leads from a neighbour of an earlier
//    one), but 29 stays 29. So every member that has a way to a root over members that stay has a
//    parent. What has no t(v), or one above seedWord::maxGeneration, leaves too; with Here it stays
//    as it is, cut off: narrowing the growth takes it.
// 11. A voxel that leaves becomes unvisited. With `barrier`, one that has a member for a neighbour
//    which stays is shut (seedWord::barrier), and so is every neighbour of such a one that is
//    neither a member (of any label) nor a pending seed: the passage stays shut where it turns out
//    wider by a voxel.

inline constexpr std::size_t widestPassage = 512;
inline constexpr int farthestPassage = 32;

/// One brick that a cut writes.
struct CutBrick {
    std::uint32_t brick = 0;
    std::vector<std::uint32_t> words; ///< all 4096, new
    std::vector<std::uint8_t> leaving; ///< labels that leave the plane where it holds them, or 0
};

struct GrowthCutOutcome {
    std::vector<CutBrick> bricks; ///< ascending; those that change
    std::uint32_t generation = 0; ///< the counter now
};

/// What leaves, by label; each voxel once.
using LeavingVoxels = std::map<std::uint32_t, std::vector<WordBricks::Voxel>>;
/// Errors: SeedsStay, NothingGrown (rule 1).
[[nodiscard]] Result<LeavingVoxels> leavingVoxels(
    const WordBricks& words, const CutGrowth& command);

/// @param words linked; all bricks that hold any. Cost ∝ what grew, and not on the volume.
/// Errors: SeedsStay, NothingGrown (rule 1).
[[nodiscard]] Result<GrowthCutOutcome> cutGrowth(const WordBricks& words, const CutGrowth& command);

} // namespace core

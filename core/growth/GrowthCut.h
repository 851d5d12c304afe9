// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/growth/WordBricks.h"

#include <map>

namespace core {

// What CutGrowth takes away. It is found for each label that is not frozen by itself, the lowest
// first; "members" are those of the label, "neighbours" all 26. Everything is a whole number, and
// nothing depends on an order.
//
// 1. The sketch is the members among the voxels named whose generation is not 0.
// 2. Roots are the members that are seeds or of generation 0; they have no parents. The parents of
//    any other member are the members of an earlier generation among its neighbours over faces; if
//    its direction is 6 or more, over edges too; if it is 18 or more, over corners too.
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
// 7. For each neck a cut is made, and that of the fewest voxels is taken, of equals that of the
//    lowest n. It is N, if that is more than `widestPassage` voxels; else it is
//    put where the passage is narrowest near N. Let D be what leaves by rule 9 if N is cut. Let the
//    surroundings be the members that can be reached from N in at most r steps to neighbours, with
//    r = 2 + the longest side of N's box in voxels, at most `farthestPassage`. Of these, sources
//    are those outside D that are r steps away, or roots; sinks are those in D that are r steps
//    away, or of a generation from the lowest m > n on at which w(m) or b(m) is as great as the
//    numerator of q(n). The cut is the smallest set of voxels of the surroundings without which no
//    way over neighbours leads from a source to a sink (both may be in it); of such sets the one
//    nearest to the sources: what is reached from them is the least. Where there is
//    no source or no sink, or a root is in it, the cut is N.
// 8. Where there is no neck the cut is the sketch; with How::Neck nothing leaves then.
// 9. Of the cut all members leave whose generation is not 0, and then every member that has parents
//    when all of them leave. With How::Here only the sketch leaves.
// 10. A voxel that leaves becomes unvisited. With `barrier`, one that has a member for a neighbour
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

/// What leaves, by label (rules 1 … 9); each voxel once.
using LeavingVoxels = std::map<std::uint32_t, std::vector<WordBricks::Voxel>>;
[[nodiscard]] LeavingVoxels leavingVoxels(const WordBricks& words, const CutGrowth& command);

/// @param words linked; all bricks that hold any. Cost ∝ what grew, and not on the volume.
[[nodiscard]] GrowthCutOutcome cutGrowth(const WordBricks& words, const CutGrowth& command);

} // namespace core

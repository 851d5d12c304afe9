// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/WordBricks.h"

#include <map>

namespace core {

// The rules of CutGrowth: what a cut removes from a growth. They are applied to each label that
// is not locked by itself, the lowest first. "Members" are those of the label, "neighbours" are all
// 26 unless something else is said. All numbers are integers, and no result depends on an order.
//
// 1. The sketch is the set of members among the given voxels. The cut is refused with
//    ErrorCode::SeedsStay if a root (rule 2) of any label that is not locked is among them, and
//    with ErrorCode::NothingGrown if no label has a sketch. (Backwards: see also rule 12.)
// 2. Roots are the members that are seeds or of generation 0; they have no parents. The parents of
//    any other member are its neighbours that are members of an earlier generation: its face
//    neighbours; if its direction is 6 or more, its edge neighbours too; if that is 18 or more, its
//    corner neighbours too. (For a direction of 29, the lowest direction that leads from a member
//    of an earlier generation is taken instead.)
// 3. A front is a set of members of one generation that is connected over the first `connectivity`
//    directions.
// 4. The way consists of the fronts that contain a voxel of the sketch and, repeatedly, of the
//    fronts that contain a parent of a voxel of the way. w(n) is the number of its voxels of
//    generation n.
// 5. Beyond the sketch lie the fronts that contain a voxel of it and, repeatedly, the members that
//    have a parent there. b(n) is the number of these voxels of generation n.
// 6. For a generation n with w(n) > 0 let
//        q(n) = min(greatest w(m) of m < n; greatest of w(m) and b(m) of m > n) / w(n).
//    Consider the generations with q(n) ≥ 3/2. Necks are: the one with the greatest q, of equal
//    ones the lowest; and every one with at least half that q for which w(m) > w(n) or w(m) = 0 for
//    m = n − 4 … n − 1, and w(m) ≥ w(n) or w(m) = 0 for m = n + 1 … n + 4. N is the set of voxels
//    of the way of such a generation.
// 7. Behind a set of members lie those of the set that are no roots, and every member that has
//    parents, all of which lie behind it.
// 8. For each neck a cut is determined. It is N if N has more than `widestPassage` voxels;
//    otherwise it is placed where the passage is narrowest near N:
//    - D is what lies behind N.
//    - The surroundings are the members that can be reached from N in at most r steps between
//      neighbours; r is 2 + the longest side of N's bounding box in voxels, at most
//      `farthestPassage`.
//    - Sources are the voxels of the surroundings outside D that are r steps away or roots.
//    - Sinks are those in D that are r steps away, or whose generation is at least the lowest m > n
//      at which w(m) or b(m) is as great as the numerator of q(n).
//    - The cut is the smallest set of voxels of the surroundings without which no path over
//      neighbours leads from a source to a sink; sources and sinks may be in it. Of several such
//      sets it is the one nearest to the sources, from which the least can be reached from them.
//    - If there is no source or no sink, or if a root is in the cut, the cut is N.
//    Only cuts behind which the whole sketch lies count. Of these the one with the fewest voxels is
//    taken, of equal ones that of the lowest n.
// 9. What leaves depends on How. Roots never leave.
//    - Neck: what lies behind the cut, however near to the roots; nothing if there is no cut.
//    - Subtree: of what lies behind the cut and the sketch together (without a cut: behind the
//      sketch), the sketch and all that is no nearer to the roots than to the sketch. Distances are
//      steps between members that are neighbours over the first K directions, where K is 6, 18 or
//      26: the most directions in which rule 2 looks for parents of a member of the label. What can
//      be reached from neither leaves.
//    - Here: the sketch.
// 10. What lies behind the cut and the sketch (Here: behind the sketch) and stays may have lost its
//    parents. For such a voxel v, t(v) is the least number that is at least the generation of v and
//    greater than that of some neighbour in the first K directions that stays (than t of the
//    neighbour, if that is such a voxel too). If t(v) differs from the generation of v, or if no
//    parent of v stays with a number below t(v), the word becomes member(t(v), label, d), where d
//    is the lowest direction below K that leads from a neighbour with a number below t(v); a
//    direction of 29 stays 29. So every member that is connected to a root over members that stay
//    has a parent. A voxel without t(v), or with one above seedWord::maxGeneration, leaves too;
//    with Here it stays as it is, disconnected, until the growth is narrowed.
// 11. A voxel that leaves becomes unvisited. With `barrier`, a voxel that leaves and has a
//     neighbour that is a member of the label and stays becomes a barrier (seedWord::barrier), and
//     so do those of its neighbours that are neither members (of any label) nor pending seeds: the
//     passage stays closed even if it turns out to be a voxel wider.
// 12. With Backwards, `steps` decides what leaves instead of rules 3 to 9. "Near" are the members
//     that are no roots and, by the distances of rule 9, no nearer to the roots than to the sketch;
//     the sketch is near.
//     - The ancestors of step 1 are the sketch. The ancestors of a later step are those of the
//       previous step and all of their parents that are near.
//     - After a number of steps, the ancestors of the last step leave and, repeatedly, every near
//       member with a parent that leaves. So the first step removes the sketch and what descends
//       from it, and each further step removes a generation of parents and what descends from them.
//     - The steps end when the ancestors have no further parent that is near. Further steps remove
//       nothing; no step removes less than the one before it.
//     - The cut is refused with ErrorCode::EverythingGrown if all members but the roots of a label
//       that has a sketch would leave.
//     - Rules 10 and 11 follow; what lies behind all that leaves takes the place of what lies
//       behind the cut and the sketch.

/// Rule 8: the greatest number of voxels of a neck for which the narrowest cut is searched, and the
/// greatest number of steps around it.
inline constexpr std::size_t widestPassage = 512;
inline constexpr int farthestPassage = 32;

/// One brick that a cut writes.
struct CutBrick {
    std::uint32_t brick = 0;
    std::vector<std::uint32_t> words; ///< all 4096 words, as they become
    /// 4096: the label that the plane loses there if it holds it; 0: none
    std::vector<std::uint8_t> leaving;
};

struct GrowthCutOutcome {
    std::vector<CutBrick> bricks; ///< ascending; those that change
    std::uint32_t generation = 0; ///< the counter after the cut
};

/// Voxels that leave, by label; each once.
using LeavingVoxels = std::map<std::uint32_t, std::vector<WordBricks::Voxel>>;
/// The sketch of each label, ascending. Errors: SeedsStay, NothingGrown (rule 1).
[[nodiscard]] Result<LeavingVoxels> sketchedVoxels(
    const WordBricks& words, const CutGrowth& command);
/// The voxels that leave. Errors: SeedsStay, NothingGrown (rule 1), EverythingGrown (rule 12).
[[nodiscard]] Result<LeavingVoxels> leavingVoxels(
    const WordBricks& words, const CutGrowth& command);

/// Carries out a cut. The cost depends on what has grown, not on the size of the volume.
/// @param words linked; all bricks of the plane that hold any words
/// Errors: SeedsStay, NothingGrown (rule 1), EverythingGrown (rule 12).
[[nodiscard]] Result<GrowthCutOutcome> cutGrowth(const WordBricks& words, const CutGrowth& command);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// How wide a passage must be for growth to go through it: a ball must be able to roll through,
/// voxel by voxel. Both engines follow this rule exactly:
///
/// |d|² = Σ (spacing[a] · d[a])² over the axes. B(c), the ball at c, is all places w with
///   |w − c|² ≤ reach.
/// isFree(label, q) holds for a voxel of the volume if
///   - allows(label, q) of GrowLimits holds,
///   - q is no barrier,
///   - q is among the voxels of GrowBurst::range, if there is one, and
///   - the label plane as it was at the opening holds 0, the label itself or a label in
///     `overwritable` at q, or q was grown: it is a member of a generation above 0, its direction
///     is neither 29 nor 30, and its label is not in `lockedLabels`. So labels that grow side by
///     side are no walls to each other, and the number of bursts makes no difference.
/// isCentre(label, c) holds for a voxel of the volume if all of B(c) is free. For a place outside
///   the volume the nearest voxel inside is tested.
/// room(label, q) is the least |q − c|² over all centres c whose B(c) contains q; if there is none,
///   it is `nowhere`, which is greater than any other value.
/// entry(label, q) is the same over those centres whose ball contains a seed of the label: a
///   pending seed, a member that is a seed, or a member of generation 0, after the opening has
///   removed members.
///
/// passes(label, p, q) is asked of a voxel q that is not a seed and of its parent p. It holds if
///   room(q) is not nowhere and one of these holds:
///     room(p) = room(q) = 0           the ball rolls from centre to centre
///     room(p) < room(q)               the ball fills what it covers, only outwards
///     entry(q) < entry(p) ≠ nowhere   growth goes from a seed at the rim of a ball to its centre;
///                                     at a centre (room(q) = 0) this needs entry(q) = 0
///
/// So growth fills what is covered by balls that can be reached by rolling from a ball that
/// contains a seed. Only where these meet balls that cannot be reached, in a hole for example, each
/// voxel belongs to the nearest centre. A centre is reached only by rolling from one whose ball
/// contains a seed, since only the first and the last line lead to room 0. Growth cannot leave what
/// a ball filled: a rule that only asked for one ball that contains both p and q would lead through
/// every hole in a thin wall, since balls on both sides of the wall meet in the hole. A seed that
/// is in no ball stays alone. All this depends on the state at the opening and not on what has
/// grown since, so the result does not depend on the order of growth. A ball that is only its
/// centre restricts nothing.
struct Passage {
    glm::ivec3 spacing{0}; ///< of the voxels, in units in which the squares fit 16 bits
    int reach = 0; ///< square of the ball's radius; 0: growth goes through everything
    bool operator==(const Passage&) const = default;
};

/// How many voxels a ball extends from its centre along each axis; 0 where nothing is asked.
[[nodiscard]] glm::ivec3 reachOf(const Passage& passage);
/// Whether a width is asked for: a ball is more than its centre.
[[nodiscard]] bool isAsked(const Passage& passage);

constexpr int greatestPassageReach = 15; ///< voxels, along any axis
/// Whether its numbers are in range: nothing is asked, or each spacing is 1 … 256, the squares fit
/// 16 bits, and balls extend at most greatestPassageReach.
[[nodiscard]] bool isSound(const Passage& passage);

} // namespace core

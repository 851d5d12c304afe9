// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// How wide a place must be for growth to go through it: a ball must be able to roll through, voxel
/// by voxel. The rule, to the bit:
///
/// |d|² = Σ (spacing[a] · d[a])² over the axes; B(c) are all places w with |w − c|² ≤ reach.
///
/// isFree(label, q), of a voxel of the volume: allows(label, q) of GrowLimits holds, q is no
///   barrier, and the label plane as it was at the opening holds at q 0, the label itself or one
///   in `overwritable`, or else q was grown: is a member of a generation above 0, of a direction
///   that is neither 29 nor 30, and its label not in `frozen`. So labels that grow side by side
///   are no walls to each other, and it makes no difference in how many bursts they came.
/// isCentre(label, c), of a voxel of the volume: all of B(c) is free, where for a place outside the
///   volume the nearest voxel inside stands.
/// room(label, q): the least |q − c|² of all centres c whose B(c) holds q; `nowhere`, which is more
///   than any other, if there is none.
/// entry(label, q): likewise of those centres whose ball holds a seed of the label: a pending one,
///   a member that is a seed, or a member of generation 0, after the opening has taken back what
///   had to leave.
///
/// passes(label, p, q), asked of a voxel q that is not a seed, p being the parent: room(q) is not
///   nowhere, and one of these holds:
///     room(p) = room(q) = 0       the ball rolls on from centre to centre;
///     room(p) < room(q)           it fills, outwards only, what it covers;
///     entry(q) < entry(p) ≠ nowhere   from a seed at its rim to its centre; at a centre (room(q) =
///                                 0) only if it is one of those (entry(q) = 0).
///
/// So what is grown is what balls cover that can be rolled to from one that holds a seed; only
/// where balls that can not be rolled to meet those, in a hole say, each voxel goes by the centre
/// that is nearest. No centre is ever reached but by rolling from one whose ball holds a seed: into
/// room 0 lead just the first line and the last. What a ball fills it cannot leave again: asking
/// only for a ball that holds both p and q would lead through every hole in a thin wall, since
/// balls on both sides of it meet in the hole. A seed that no ball holds stays alone. All of it
/// depends on what stands at the opening and on nothing that grows, so the result is that of a
/// flood, whatever its order. A ball of which only the centre is left asks nothing.
struct Passage {
    glm::ivec3 spacing{0}; ///< of voxels, in units of which squares fit
    int reach = 0; ///< squared half width; 0: growth goes through everything
    bool operator==(const Passage&) const = default;
};

/// Voxels that a ball reaches from its centre along each axis; 0 where nothing is asked.
[[nodiscard]] glm::ivec3 reachOf(const Passage& passage);
/// Whether anything is asked: a ball holds more than its centre.
[[nodiscard]] bool isAsked(const Passage& passage);

constexpr int greatestPassageReach = 15; ///< voxels, along any axis
/// Whether its numbers are in range: nothing is asked, or spacing is 1 … 256 and reach so that
/// squares fit 16 bits and balls reach at most greatestPassageReach.
[[nodiscard]] bool isSound(const Passage& passage);

} // namespace core

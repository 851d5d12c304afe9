// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/Passage.h"
#include "core/growth/SeedGroups.h"
#include "core/sculpt/CapsuleSweep.h"

#include <glm/glm.hpp>

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

// Growth as an engine sees it: integers only. Words are those of core/growth/SeedWord.h.
// SpreadLabels, growing from seeds: core/growth/SeedSpread.h.
//
// What growth takes from other labels it can give back: Field::Beneath holds, by voxel, the label
// that the plane held before a member came. It is asked for only where a member is that added its
// label to the plane: of a generation above 0 and of a direction that is neither 29 nor 30.
// Everywhere else it means nothing, whatever it says, so that who paints, erases or fills need not
// care for it. That holds since
// - only GrowBurst makes such a member, and where it makes one, it writes what is beneath;
// - where such a member leaves and the plane holds its label, it is "given back": the plane becomes
//   what is beneath, and beneath becomes 0. A label that was locked meanwhile gets it back, too;
// - EraseLabel takes its label from what is beneath: no segment comes back once it is deleted.

/// First take pending seeds of a segment away: where the word is pendingSeed(label) it becomes
/// unvisited. Then mark voxels as its pending seeds: word = min(word, pendingSeed(label)) where the
/// word is not a member's.
struct SeedPlacement {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    std::vector<glm::ivec3> voxels{}; ///< inside the volume
    std::vector<glm::ivec3> taken{}; ///< likewise
};

/// What growth asks for beyond its interval and the label plane; all that is given must hold.
/// Where a rule looks at a voxel outside the volume, the nearest one inside stands for it.
///
/// within(label, q): lowCode ≤ code(q) ≤ highCode, and with sigmas256 > 0 code(q) also lies in
///   seedInterval(sums, sigmas256) (SeedStatistics.h) of one of the label's groups of seeds. Its
///   seeds are, as the burst finds it, every pending seed of the label and every member of it that
///   is a seed (seedWord::isSeed). Each of GrowBurst::seedGroups that bears the label is a group of
///   those seeds that lie at its voxels (a seed may be in several), and the seeds that are in none
///   are one more; where none bears the label, all are. To the sums of its groups each seed adds
///   the voxels of the volume that lie within seedReach of it along each axis and whose code is in
///   lowCode … highCode.
/// magnitude(q) = ⌊√(tx² + ty² + tz²)⌋, where ta = min(⌊gradientWeights[a] · |code(q + ea) −
///   code(q − ea)| / 1024⌋, 32767) along each axis a.
/// allows(label, q), asked of every voxel, seeds too:
///   within(label, q); magnitude(q) ≤ gradient; of the 27 voxels q + {−1, 0, 1}³ at least
///   `majority` are within(label, ·); with onlyVisible the coverage of the composed layers is below
///   128 at q; with boxed boxFrom ≤ q ≤ boxTo on each axis.
/// follows(label, p, q), asked of a voxel q that is not a seed, p being the parent:
///   |code(q) − code(p)| ≤ difference; |magnitude(q) − magnitude(p)| ≤ gradientDifference;
///   passes(label, p, q) of Passage.h, where `passage` asks for anything.
struct GrowLimits {
    std::optional<int> difference{};
    std::optional<int> gradient{};
    std::optional<int> gradientDifference{};
    glm::ivec3 gradientWeights{0}; ///< 0 … 65535 each
    int majority = 0; ///< 0 … 27
    bool onlyVisible = false;
    bool boxed = false;
    glm::ivec3 boxFrom{0};
    glm::ivec3 boxTo{0};
    int sigmas256 = 0; ///< 256ths of a standard deviation, to 25600; 0: the interval as given
    Passage passage{};
    bool operator==(const GrowLimits&) const = default;
};

/// Whether every number is in its range; differences and magnitudes are not below 0.
[[nodiscard]] bool isSound(const GrowLimits& limits);

/// What becomes of the members that are there when a burst opens. Those of labels in `frozen` stay
/// as they are, and so does what was painted (generation 0).
enum class GrowOpening : std::uint8_t {
    GoOn, ///< they stay
    /// Those that qualify no more leave, with what hung on them. A seed that is not accepted waits
    /// again; any other member stays if it is accepted and has a neighbour that stays, of its label
    /// and of an earlier generation. The lowest direction that leads from such a neighbour is then
    /// its own, unless that is 29.
    Narrow,
    /// All leave: as ShrinkGrowth to generation 0.
    Restart,
};

/// What a voxel of a front measures, by the axes along which growth came to it (LeakGuard.h).
struct FrontMeasure {
    /// µm² by axes: bit 0: x, 1: y, 2: z; 0: none is known.
    std::array<std::int64_t, 8> areaUm2{};
    std::int64_t volumeUm3 = 0;
    bool operator==(const FrontMeasure&) const = default;
};
/// @param spacingMm of the voxels: rounded to whole µm, at least one
[[nodiscard]] FrontMeasure frontMeasure(const glm::dvec3& spacingMm);

/// When a growth stops by itself: LeakGuard.h says what an alarm is.
struct GuardRule {
    int factor256 = 512; ///< 256ths: so many times the narrow place
    std::int64_t excess = 60; ///< and so many µm² more than there; without a measure: voxels
    std::int64_t window = 20; ///< µm that a narrow place lies back at most; else generations
    std::optional<FrontMeasure> measure{}; ///< none: voxels and generations are counted
    bool operator==(const GuardRule&) const = default;
};

/// Whether every number is in its range.
[[nodiscard]] bool isSound(const GuardRule& rule);

/// A front that burst out of a narrow place.
struct LeakAlarm {
    std::uint32_t generation = 0; ///< of the front
    std::uint32_t narrow = 0; ///< generation of the narrow place
    std::int64_t voxels = 0; ///< of the front
    std::int64_t areaUm2 = 0; ///< of the front; 0 where voxels are counted
    glm::ivec3 voxel{0}; ///< one of them
    bool operator==(const LeakAlarm&) const = default;
};

/// Grow all labels of a plane at once (seed A §5.3), ring by ring.
///
/// accept(label, q): the label is not in `frozen`, the limits allow it at q (of which
/// lowCode ≤ code(q) ≤ highCode is one), and the label plane as it was at the opening, once all had
/// left, holds at q 0, the label itself, or a label in `overwritable`. Of a member that may leave
/// by Narrow it is asked as if that one had been given back.
/// Neighbours of a voxel are the 6 that share a face with it, the 18 that share a face or an edge,
/// or all 26: the first so many of seedWord::offsets.
/// Opening: what leaves by GrowOpening leaves as ShrinkGrowth says, and the generation is then the
/// greatest that a member has. Every pending seed that is accepted becomes member(generation + 1,
/// label, 31); if there was one, the generation is now one more. Then each step: every voxel that
/// is no member and has a neighbour that was a member before the step, whose label it accepts and
/// which it follows,
/// becomes member(generation + 1, label, direction), the smallest such word; if there was one, the
/// generation is one more, else the growth is at closure and further steps do nothing.
/// Where the plane held the label itself, the direction is 30 for a seed and 29 else (SeedWord.h),
/// unless `tellsHeld` is false.
/// At generation seedWord::maxGeneration nothing is added any more, by opening or step, and this is
/// not called closure.
/// Closing with commit: the label plane receives the label of every member whose generation is
/// greater than at the opening; beneath becomes what it held before, but stays where that was the
/// label itself. Without `tellsHeld` beneath becomes 0 instead (sessions of before).
/// `EngineResult::generation` tells where it stopped.
/// The label plane shows the members of every finished generation at once, so that pictures and
/// readouts follow a running burst; a rollback takes them back.
struct GrowBurst {
    std::uint8_t plane = 0;
    int lowCode = 0;
    int highCode = -1;
    int connectivity = 6; ///< 6, 18 or 26
    GrowLimits limits{};
    GrowOpening opening = GrowOpening::GoOn;
    std::uint32_t generation = 0; ///< the counter at the opening; no member has a greater one
    std::bitset<256> overwritable{};
    std::bitset<256> frozen{}; ///< labels that do not grow: locked segments
    bool tellsHeld = true; ///< false: directions 29 and 30 are not used
    /// After a generation that alarms it no step is done any more, whatever is asked for.
    std::optional<GuardRule> guard{};
    std::vector<SeedGroup> seedGroups{}; ///< only looked at with sigmas256 > 0
};

/// Whether its limits and groups are, and with a passage width the opening is not Narrow (who stays
/// would depend on rooms that change; Restart gives what would have grown) and tellsHeld is true.
[[nodiscard]] bool isSound(const GrowBurst& burst);

/// Take back what a growth added after generation `keep`, for every label but those in `frozen`:
/// its exact inverse (seed A §5.3, shrinking). Of each member of a later generation
///
///   a seed stays with `keepSeeds`, as one of generation 1; else it becomes a pending seed again;
///   any other becomes seedWord::unvisited;
///
/// and those that added their label to the plane are given back. So voxels that bore the label
/// before the growth came keep it, and others return to the label that they were taken from; a
/// pending seed that was grown over is not put back. The generation is then `keep`, or the greatest
/// that a member has, if that is more.
struct ShrinkGrowth {
    std::uint8_t plane = 0;
    std::uint32_t generation = 0; ///< the counter at present; no member has a greater one
    std::uint32_t keep = 0; ///< not above it
    bool keepSeeds = false;
    std::bitset<256> frozen{};
};

/// Of an open ShrinkGrowth: from now on voxels, words and counter are as if it had been opened with
/// this `keep`, and with `keepSeeds` where that is 0. Both ways, as often as one likes. Cost ∝ the
/// bricks in which generations between the old and the new one lie.
struct ShrinkTo {
    std::uint32_t keep = 0; ///< not above the counter at the opening
};

/// Take back what grew through some places. Which voxels leave, which are shut, and when it is
/// refused, is told by the rules of GrowthCut.h; what they added to the plane is given back. The
/// generation is then the greatest that a member of the plane has; where nothing leaves, as it was.
struct CutGrowth {
    enum class How : std::uint8_t {
        Here, ///< only the voxels named
        /// They, and what grew through them, cut off at its narrowest passage; what is nearer to
        /// the seeds stays.
        Subtree,
        Neck, ///< all that grew through a narrow passage before them; where there is none, nothing
    };
    std::uint8_t plane = 0;
    How how = How::Subtree;
    bool barrier = true; ///< the cut is shut
    int connectivity = 26; ///< of fronts: 6, 18 or 26
    std::uint32_t generation = 0; ///< the counter at present
    std::bitset<256> frozen{};
    std::vector<glm::ivec3> voxels{}; ///< inside the volume
    bool operator==(const CutGrowth&) const = default;
};

/// What a CutGrowth would take, as it is told before it does.
struct ForeseenCut {
    struct Brick {
        std::uint32_t brick = 0;
        std::bitset<BrickGrid::voxelsPerBrick> taken; ///< the plane would lose its label here
        bool operator==(const Brick&) const = default;
    };
    std::int64_t members = 0; ///< that would leave the growth; 0: it would do nothing
    std::int64_t voxels = 0; ///< that the plane would lose a label at
    std::vector<Brick> bricks{}; ///< ascending; those that hold any of these
    bool operator==(const ForeseenCut&) const = default;
};

/// Shut places to growth along a path, or open them again. Looked at are the voxels inside
/// (CapsuleSweep.h, rule 4).
///
/// Shut: every word becomes seedWord::barrier but those that bear a label in `frozen` (a member's
/// or a pending seed's). What growth added there to the plane is given back.
/// Erase: a barrier becomes unvisited, so growth goes on through it. The label plane stays.
struct PaintBarrier {
    std::uint8_t plane = 0;
    bool erase = false;
    std::bitset<256> frozen{};
    CapsuleFrame frame;
};

/// Shut places to growth that are listed, or open them again: as PaintBarrier, at each of them.
struct ShutListed {
    struct Brick {
        std::uint32_t brick = 0;
        std::bitset<BrickGrid::voxelsPerBrick> places{};
        bool operator==(const Brick&) const = default;
    };
    std::uint8_t plane = 0;
    bool erase = false;
    std::bitset<256> frozen{};
    std::vector<Brick> bricks{}; ///< ascending, each once
};

/// Whether its bricks ascend and are the volume's.
[[nodiscard]] bool isSound(const ShutListed& edit, int brickCount);

[[nodiscard]] Result<void> checkSound(const SeedPlacement& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const GrowBurst& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const ShrinkGrowth& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const CutGrowth& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const PaintBarrier& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const ShutListed& edit, const BrickGrid& grid);

} // namespace core

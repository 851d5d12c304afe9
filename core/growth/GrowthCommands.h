// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/GrowthRange.h"
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

// Commands that change a growth, as an engine receives them: plain data, every number an integer.
// Seed words are described in core/growth/SeedWord.h; SpreadLabels ("grow from seeds") has its own
// header, core/growth/SeedSpread.h.
//
// Growth can give back the labels that it overwrote: for each voxel, Field::Overwritten holds the
// label that the label plane held before a member claimed the voxel. The value is read only where a
// member has added its own label to the plane, that is where its generation is above 0 and its
// direction is neither 29 nor 30. Everywhere else the value is meaningless, so commands that paint,
// erase or fill need not maintain it. Three rules make this work:
// - Only GrowBurst creates such members, and it stores the overwritten label whenever it does.
// - When such a member leaves the growth while the plane still holds its label, the voxel is "given
//   back": the plane receives the overwritten label, and the stored one becomes 0. A label receives
//   its voxel even if its segment was locked in the meantime.
// - EraseLabel removes its label from the stored ones too, so no deleted segment comes back.

/// Replace pending seeds of a segment. First, at `taken`, every word that is pendingSeed(label)
/// becomes unvisited. Then, at `voxels`, every word that is not a member's becomes
/// min(word, pendingSeed(label)).
struct SeedPlacement {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    std::vector<glm::ivec3> voxels{}; ///< inside the volume
    std::vector<glm::ivec3> taken{}; ///< inside the volume
};

/// Conditions of growth beyond its interval of codes and the label plane; all that are set must
/// hold. Where a rule reads a voxel outside the volume, the nearest voxel inside is read instead.
///
/// suits(label, c) holds for a code if lowCode ≤ c ≤ highCode and, with sigmas256 > 0, c also lies
///   in seedInterval(sums, sigmas256) (SeedStatistics.h) of a group of the label's seeds:
///   - The seeds of a label are its pending seeds and its members that are seeds
///     (seedWord::isSeed), as they are when the burst opens.
///   - Each of GrowBurst::seedGroups that has the label is the group of those seeds that lie at its
///     voxels; a seed may belong to several groups. The seeds that belong to none are one more
///     group; if no group has the label, that one holds all its seeds.
///   - To the sums of its groups each seed adds the voxels of the volume that lie within seedReach
///     of it along each axis and whose code is in lowCode … highCode.
/// within(label, q) is suits(label, code(q)); with `smoothed` it is suits(label, median(q)).
/// median(q) is the weighted median of the codes of the 27 voxels q + {−1, 0, 1}³. A voxel that
///   lies aside of q along no axis weighs 9, along one axis 4, along two 2, along three 1; that is
///   65 together. The median is the least code c for which the voxels of a code of at most c weigh
///   33 or more together. So it is the code of one of them, nothing is rounded, and there are no
///   ties: c is at least a bound if what lies below the bound weighs at most 32.
/// magnitude(q) = ⌊√(tx² + ty² + tz²)⌋ measures the gradient; along each axis a it has
///   ta = min(⌊gradientWeights[a] · |code(q + ea) − code(q − ea)| / 1024⌋, 32767).
/// allows(label, q) is asked of every voxel, seeds included. It holds if
///   - within(label, q);
///   - magnitude(q) ≤ gradient;
///   - suits(label, code(·)) holds for at least `majority` of the 27 voxels q + {−1, 0, 1}³;
///   - with onlyVisible, the coverage of the composed sculpt layers is below 128 at q;
///   - with boxed, boxFrom ≤ q ≤ boxTo on each axis.
/// follows(label, p, q) is asked of a voxel q that is not a seed and of its parent p. It holds if
///   - |code(q) − code(p)| ≤ difference;
///   - |magnitude(q) − magnitude(p)| ≤ gradientDifference;
///   - passes(label, p, q) of Passage.h, where `passage` asks for a width.
struct GrowLimits {
    std::optional<int> difference{};
    std::optional<int> gradient{};
    std::optional<int> gradientDifference{};
    glm::ivec3 gradientWeights{0}; ///< 0 … 65535 each
    int majority = 0; ///< 0 … 27
    bool smoothed = false; ///< medians are compared with the interval instead of codes
    bool onlyVisible = false;
    bool boxed = false;
    glm::ivec3 boxFrom{0};
    glm::ivec3 boxTo{0};
    int sigmas256 = 0; ///< 256ths of a standard deviation, to 25600; 0: codes alone decide
    Passage passage{};
    bool operator==(const GrowLimits&) const = default;
};

/// Whether every number is in its range; differences and magnitudes must not be negative.
[[nodiscard]] bool isSound(const GrowLimits& limits);

/// What the opening of a burst does with members that are already there. Members whose label is in
/// `lockedLabels` always stay, and so does what was painted (generation 0).
enum class GrowOpening : std::uint8_t {
    GoOn, ///< they stay
    /// Members that no longer qualify leave, and with them those that depended on them. A seed that
    /// is not accepted becomes a pending seed again. Any other member stays if it is accepted and
    /// has a neighbour that stays, that has its label and an earlier generation, and that it
    /// follows. The lowest direction that leads from such a neighbour becomes its direction, unless
    /// that is 29.
    Narrow,
    /// All of them leave, as by ShrinkGrowth to generation 0.
    Restart,
};

/// The area and volume that a voxel adds to a front of growth (LeakGuard.h).
struct FrontMeasure {
    /// µm², by the axes along which growth reached the voxel (bit 0: x, 1: y, 2: z); 0: unknown.
    std::array<std::int64_t, 8> areaUm2{};
    std::int64_t volumeUm3 = 0;
    bool operator==(const FrontMeasure&) const = default;
};
/// @param spacingMm voxel spacing; it is rounded to whole µm, of which there is at least one
[[nodiscard]] FrontMeasure frontMeasure(const glm::dvec3& spacingMm);

/// When a growth stops because it has probably leaked. LeakGuard.h defines the alarm.
struct GuardRule {
    int factor256 = 512; ///< 256ths: how many times larger than the narrow place a front must be
    std::int64_t excess = 60; ///< how much larger, too: µm²; without a measure: voxels
    /// how far back the narrow place may lie: µm; without a measure: generations
    std::int64_t window = 20;
    std::optional<FrontMeasure> measure{}; ///< none: voxels and generations are counted instead
    bool operator==(const GuardRule&) const = default;
};

/// Whether every number is in its range.
[[nodiscard]] bool isSound(const GuardRule& rule);

/// The report that a front has burst out of a narrow place.
struct LeakAlarm {
    std::uint32_t generation = 0; ///< of the front
    std::uint32_t narrow = 0; ///< generation of the narrow place
    std::int64_t voxels = 0; ///< of the front
    std::int64_t areaUm2 = 0; ///< of the front; 0 where voxels are counted
    glm::ivec3 voxel{0}; ///< one of them
    bool operator==(const LeakAlarm&) const = default;
};

/// Grow all labels of a plane at once, one ring of voxels per generation (seed A §5.3).
///
/// accept(label, q) holds if
///   - the label is not in `lockedLabels`;
///   - the limits allow it at q, which includes lowCode ≤ code(q) ≤ highCode;
///   - at q the label plane holds 0, the label itself or a label in `overwritable`. What counts is
///     the plane after members have left at the opening; for a member that Narrow examines, it is
///     the plane as if that member had been given back;
///   - q is among the voxels of `range`, if there is one.
/// Neighbours of a voxel are the first `connectivity` of seedWord::offsets: the 6 that share a face
///   with it, the 18 that share a face or an edge, or all 26.
/// Opening: members leave according to GrowOpening, each as ShrinkGrowth says; where the opening is
///   not GoOn, the generation becomes the greatest that a member has. Then every pending seed that
///   is accepted becomes member(generation + 1, label, 31); if there was one, the generation
///   increases by 1.
/// Step: every voxel that is no member and has a neighbour that was a member before the step, whose
///   label it accepts and which it follows, becomes member(generation + 1, label, direction), the
///   smallest such word. If there was one, the generation increases by 1; otherwise the growth is
///   at closure and further steps do nothing. A barrier never becomes a member.
/// Held labels: where the plane already held the label itself, the direction is 30 for a seed and
///   29 otherwise (SeedWord.h), unless `tellsHeld` is false.
/// Limit: at generation seedWord::maxGeneration neither opening nor step adds anything, and this is
///   not called closure.
/// Commit: the label plane receives the label of every member whose generation is greater than at
///   the opening. The stored overwritten label becomes what the plane held before, and is unchanged
///   where that was the label itself; without `tellsHeld` it becomes 0 (for older sessions).
///
/// `EngineResult::generation` is the generation at which it stopped. The label plane shows the
/// members of each finished generation at once, so pictures and readouts follow a running burst; a
/// rollback removes them again.
struct GrowBurst {
    std::uint8_t plane = 0;
    int lowCode = 0;
    int highCode = -1;
    int connectivity = 6; ///< 6, 18 or 26
    GrowLimits limits{};
    GrowOpening opening = GrowOpening::GoOn;
    std::uint32_t generation = 0; ///< the counter at the opening; no member has a greater one
    std::bitset<256> overwritable{};
    std::optional<GrowthRange> range{}; ///< none: all voxels
    std::bitset<256> lockedLabels{}; ///< labels that do not grow: those of locked segments
    bool tellsHeld = true; ///< false: directions 29 and 30 are not used
    /// After a generation that raises an alarm no further step is done, however many are requested.
    std::optional<GuardRule> guard{};
    std::vector<SeedGroup> seedGroups{}; ///< read only with sigmas256 > 0
};

/// Whether its limits and groups are sound, and, with a passage width, the opening is not Narrow
/// (which members stay would depend on rooms that change; Restart gives the correct result) and
/// tellsHeld is true.
[[nodiscard]] bool isSound(const GrowBurst& burst);

/// Remove what a growth added after generation `keep`, for every label that is not in
/// `lockedLabels`: the exact inverse of growing (shrinking, seed A §5.3). Of each member of a later
/// generation
/// - a seed stays as a member of generation 1 if `keepSeeds`; otherwise it becomes a pending seed;
/// - any other member becomes seedWord::unvisited.
/// Members that leave and had added their label to the plane are given back: voxels that had the
/// label before the growth came keep it, and others return to the label that was overwritten. A
/// pending seed that was grown over is not restored. The generation becomes `keep`, or the greatest
/// that a member still has if that is more.
struct ShrinkGrowth {
    std::uint8_t plane = 0;
    std::uint32_t generation = 0; ///< the generation now; no member has a greater one
    std::uint32_t keep = 0; ///< at most `generation`
    bool keepSeeds = false;
    std::bitset<256> lockedLabels{};
};

/// Moves an open ShrinkGrowth: voxels, words and generation become what they would be if it had
/// been opened with this `keep`, and with `keepSeeds` where `keep` is 0. It may be repeated in both
/// directions. The cost is that of the bricks that hold generations between the old and the new
/// one.
struct ShrinkTo {
    std::uint32_t keep = 0; ///< at most the generation at the opening
};

/// Remove what grew through some places. The rules of GrowthCut.h say which voxels leave, where
/// barriers are set, and when the command is refused. Members that leave and had added their label
/// to the plane are given back. The generation becomes the greatest that a member of the plane has;
/// if nothing leaves, it does not change.
struct CutGrowth {
    enum class How : std::uint8_t {
        Here, ///< only the given voxels
        /// The given voxels and what grew through them, cut off at its narrowest passage; what is
        /// nearer to the seeds stays.
        Subtree,
        Neck, ///< all that grew through a narrow passage before them; nothing if there is none
        /// The given voxels and what descends from them, then their parents, generation by
        /// generation; what is nearer to the seeds stays.
        Backwards,
    };
    std::uint8_t plane = 0;
    How how = How::Subtree;
    bool barrier = true; ///< set a barrier along the cut
    int connectivity = 26; ///< of fronts: 6, 18 or 26
    std::uint32_t generation = 0; ///< the generation now
    std::bitset<256> lockedLabels{};
    std::vector<glm::ivec3> voxels{}; ///< inside the volume
    std::uint32_t steps = 1; ///< with Backwards: number of steps, at least 1 (GrowthCut.h, rule 12)
    bool operator==(const CutGrowth&) const = default;
};

/// Takes an open CutGrowth with How::Backwards further: voxels, words and generation become what
/// they would be if it had been opened with this number of steps. It stops where further steps
/// remove nothing, and before the step that would remove everything. It never goes back.
struct CutFurther {
    std::uint32_t steps = 1; ///< number of steps in all, at least 1
};

/// What a CutGrowth would remove, as it is shown before it is carried out.
struct CutPreview {
    struct Brick {
        std::uint32_t brick = 0;
        std::bitset<BrickGrid::voxelsPerBrick> taken; ///< where the plane would lose its label
        bool operator==(const Brick&) const = default;
    };
    std::int64_t members = 0; ///< members that would leave the growth; 0: the cut would do nothing
    std::int64_t voxels = 0; ///< voxels at which the plane would lose its label
    std::vector<Brick> bricks{}; ///< ascending; those in which the plane would lose a label
    bool operator==(const CutPreview&) const = default;
};

/// How many voxels of a plane differ from their state when an open growth began.
struct GrowthComparison {
    std::int64_t suspended =
        0; ///< voxels that have left the growth; a wider interval recovers them
    std::int64_t reached = 0; ///< voxels that a label has claimed
    bool operator==(const GrowthComparison&) const = default;
};

/// Set barriers along a path, or remove them. It changes the voxels inside (CapsuleSweep.h, rule
/// 4).
///
/// Set: every word becomes seedWord::barrier, except the words of members and pending seeds whose
/// label is in `lockedLabels`. Members that had added their label to the plane are given back.
/// Erase: a barrier becomes unvisited, so growth may enter it again. The label plane stays as it
/// is.
struct PaintBarrier {
    std::uint8_t plane = 0;
    bool erase = false;
    std::bitset<256> lockedLabels{};
    CapsuleFrame frame;
};

/// Set barriers at listed voxels, or remove them, as PaintBarrier does along its path.
struct BarrierListed {
    struct Brick {
        std::uint32_t brick = 0;
        std::bitset<BrickGrid::voxelsPerBrick> places{};
        bool operator==(const Brick&) const = default;
    };
    std::uint8_t plane = 0;
    bool erase = false;
    std::bitset<256> lockedLabels{};
    std::vector<Brick> bricks{}; ///< ascending, each once
};

/// Whether its bricks ascend and lie in a volume of `brickCount` bricks.
[[nodiscard]] bool isSound(const BarrierListed& edit, int brickCount);

[[nodiscard]] Result<void> checkSound(const SeedPlacement& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const GrowBurst& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const ShrinkGrowth& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const CutGrowth& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const PaintBarrier& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const BarrierListed& edit, const BrickGrid& grid);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/base/Result.h"
#include "core/base/TypeList.h"
#include "core/brick/BrickGrid.h"
#include "core/delta/EditStatistics.h"
#include "core/delta/Ending.h"
#include "core/engine/ChangeFacts.h"
#include "core/engine/LabelGuard.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/GrowthProgress.h"
#include "core/growth/ProbedVoxel.h"
#include "core/growth/SeedGroups.h"
#include "core/growth/SeedSpread.h"
#include "core/growth/SeedStatistics.h"
#include "core/growth/Tolerance.h"
#include "core/sculpt/CapsuleSweep.h"
#include "core/sculpt/DrillCut.h"
#include "core/sculpt/LaserCut.h"
#include "core/sculpt/LayerWrites.h"
#include "core/sculpt/MaskPeel.h"
#include "core/sculpt/MaskScissors.h"
#include "core/sculpt/PickRay.h"
#include "core/sculpt/SparedLabels.h"

#include <bitset>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace core {

/// Names one submitted command; tickets grow by one.
using Ticket = std::uint64_t;

// --- Edits as an engine sees them: integers only, everything they read is in them. -------------
//
// Each kind X says beside its rule whether one could begin in a volume (checkEdit()):
//   Result<void> checkSound(const X&, const BrickGrid&)    Errors: InvalidField
// and stands in the list of one family, each of which is carried out by one part of an engine: none
// that is missing in either compiles (gpu/engine/BeginWork.h).

/// Take a label out of its plane: every voxel that holds it becomes 0, and every seed word that
/// bears it, a member's or a pending seed's, becomes seedWord::unvisited. So no growth goes on from
/// it; what is left of other labels keeps its generations. Where the label lies beneath
/// (GrowthCommands.h), 0 does from now on.
struct EraseLabel {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
};

/// Paint a label along a path, or erase it. Looked at are the voxels inside (CapsuleSweep.h, rule
/// 4) with lowCode ≤ code ≤ highCode; "bears" is said of words of members and of pending seeds.
///
/// Paint: a voxel that the plane holds 0, the label or a label in `overwritable` at receives the
/// label. Of these voxels' seed words: with `seeds` each that is no member of the label becomes
/// member(0, label, 31), else each that bears another label becomes unvisited. Generation 0 comes
/// before any growth, so a growth goes on from there, while shrinking it (which takes away what is
/// later than some generation) leaves what was painted; and no burst counts it as its own. A
/// barrier stays one.
/// Erase: a voxel that the plane holds the label at becomes 0, and a seed word that bears the label
/// becomes unvisited: the place is open to growth.
struct PaintLabel {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    std::bitset<256> overwritable{};
    bool erase = false;
    bool seeds = false;
    int lowCode = 0;
    int highCode = 65535;
    CapsuleFrame frame;
};

/// Carve along a path: coverage = max(coverage, cut) with the cut of CapsuleSweep.h, rule 5; to
/// restore, it is refilled as the end of rule 6 of MaskFrame.h says. Nothing happens to voxels that
/// are hidden, and those that are spared are not carved.
struct CapsuleCut {
    std::uint8_t layer = 0;
    bool restore = false;
    CapsuleFrame frame;
    std::vector<HiddenHalf> hidden{};
    SparedLabels spared{};
};

[[nodiscard]] Result<void> checkSound(const EraseLabel& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const PaintLabel& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const CapsuleCut& edit, const BrickGrid& grid);

/// Of growth: growth/GrowthCommands.h, growth/SeedSpread.h.
using GrowthEdits = TypeList<SeedPlacement, GrowBurst, ShrinkGrowth, CutGrowth, SpreadLabels>;
/// Under the pen. DrillCut, MaskPeel, MaskScissors (sculpt/DrillCut.h and so on): cut into the
/// coverage of one sculpt layer with a mask that is pressed into the volume along the view;
/// LaserCut: along the surface's normals. CapsuleCut, PaintLabel, PaintBarrier: with a brush.
using StrokeEdits =
    TypeList<DrillCut, LaserCut, MaskPeel, MaskScissors, CapsuleCut, PaintLabel, PaintBarrier>;
/// Of whole labels and layers, and of places that are listed. CoverLabel, FoldLayer:
/// sculpt/LayerWrites.h, as LabelWrites, which give labels to voxels.
using WholeEdits = TypeList<EraseLabel, CoverLabel, FoldLayer, ShutListed>;

using EngineEditVariant =
    JoinedTypes<GrowthEdits, StrokeEdits, WholeEdits, LabelWrites>::List::Variant;

/// Any one of them; like Edit (core/edits/kinds/Edit.h), its copies are compiled once.
struct EngineEdit : EngineEditVariant {
    using EngineEditVariant::variant;
    EngineEdit();
    EngineEdit(const EngineEdit& other);
    EngineEdit(EngineEdit&& other) noexcept;
    EngineEdit& operator=(const EngineEdit& other);
    EngineEdit& operator=(EngineEdit&& other) noexcept;
    ~EngineEdit();
};

/// Whether an edit could begin in a volume. Errors: InvalidField.
[[nodiscard]] Result<void> checkEdit(const EngineEdit& edit, const BrickGrid& grid);

// --- What an open edit can be told while it runs. ------------------------------------------------
// GrowAdvance: core/growth/GrowthProgress.h.

/// More of the path of DrillCut or LaserCut.
struct DrillPath {
    std::vector<DrillSample> samples;
};

/// Forget steps that were asked for and not yet done.
struct GrowPause { };

/// The open growth begins anew: as if it had been rolled back and opened so. Steps that were asked
/// for before are forgotten.
struct GrowAnew {
    GrowBurst burst;
};

/// More of the path of PaintLabel, PaintBarrier or CapsuleCut.
struct CapsulePath {
    std::vector<Capsule> capsules;
};

/// How deep an open MaskPeel is from now on; it begins with 0. Deeper or less deep than before.
struct PeelDepth {
    std::int32_t depth = 0; ///< mm16, ≥ 0
};

using EngineExtension = std::variant<DrillPath, GrowAdvance, GrowPause, CapsulePath, PeelDepth,
    ShrinkTo, GrowAnew, ForgetSpread>;

// --- Commands
// -------------------------------------------------------------------------------------

// A command that cannot be carried out changes nothing and yields ErrorCode::InvalidField:
// BeginEdit while a transaction is open; ExtendEdit or EndEdit while none is, or an extension of
// another kind of edit; a peel's depth below 0; SwapBricks, XorBricks or MuteLayers while a
// transaction is open; a brick or voxel that the volume does not have; an image that is neither
// empty nor whole, of differences (XorBricks) also one that is empty; an edit that could not begin
// (checkEdit()): a connectivity other than 6, 18 and 26; a shrinking to more than there is, also by
// ShrinkTo; a segment label of 0; a mask's frame whose pitch, rampHalfWidth or gapSamples is below
// 1; a laser, a brush's frame, what is hidden, bounds, a list of labels or places, a growth or
// groups of seeds that are not sound; a layer folded into itself; growing from seeds that is not
// sound, or with seeds of fewer than two labels; a table of opacities of another length than 256;
// TraceTolerance while a transaction is open, by a rule that is not sound (isSound()) or of a label
// without seeds; ForeseeCut while a transaction is open, or of a cut that could not begin; a box of
// codes that is empty or not within the volume. ReadBricks, ReadSeedWords, ReadCodes, ProbeVoxels,
// ProbeSeeds, PickVoxels, CountGenerations, DropTolerance and DropForesight are served while a
// transaction is open too. A CutGrowth over seeds yields ErrorCode::SeedsStay, one where nothing
// has grown NothingGrown (growth/cut/GrowthCut.h), and so does a ForeseeCut of it.

/// Open a transaction. There is at most one; its ticket names it until EndEdit.
struct BeginEdit {
    EngineEdit edit;
};
struct ExtendEdit {
    EngineExtension extension;
};
/// Close the open transaction; a commit waits for the steps that were asked for. Its result (which
/// bears the ticket of this command) lists every brick that changed since BeginEdit; after a
/// rollback none, its statistics are zero, and voxels and generation are as before.
struct EndEdit {
    Ending ending = Ending::Commit;
};
/// Put these images in place of what the bricks hold (undo, redo, opening a session). Each key
/// stands once. The result lists the bricks that differ, with statistics, as EndEdit does. Where
/// the guard does not let it, it is refused with SegmentLocked or SegmentProtected and the label.
struct SwapBricks {
    std::vector<BrickImage> bricks;
    LabelGuard guard{};
};
/// Lay differences over what the bricks hold (undo, redo, "undo only here"). A brick may stand
/// there several times. The result is that of SwapBricks.
struct XorBricks {
    std::vector<BrickImage> differences; ///< XOR images, every one with its bytes
    LabelGuard guard{};
};
/// From now on these sculpt layers are left out where layers are composed: radiation, and with it
/// strokes, picks and pictures, is that of the greatest coverage of all others. Their own coverage
/// stays, and can be cut, read and swapped. Opening a volume unmutes all. The result is empty.
struct MuteLayers {
    std::bitset<256> muted{};
};
/// Fetch bricks; the result lists each with `after` filled and `before` empty, in this order.
struct ReadBricks {
    std::vector<BrickKey> keys;
};
/// Fetch the seed words of voxels, in their order (`seedWords`).
struct ReadSeedWords {
    std::vector<glm::ivec3> voxels;
    std::uint8_t plane = 0;
};
/// Fetch the codes of a box: 16 bits each, x fastest (`codes`). Cost: it waits until the box has
/// been copied, so a large one costs frames.
struct ReadCodes {
    VoxelBox box;
};
/// Codes, labels and pending seeds at voxels, for readouts; and tolerances where a tolerance field
/// stands.
struct ProbeVoxels {
    std::vector<glm::ivec3> voxels;
    std::uint8_t plane = 0; ///< of the labels
};
/// What lies around the seeds of a plane's labels: the sums that a GrowBurst with this interval and
/// these groups would narrow it by (GrowLimits), if it opened now.
struct ProbeSeeds {
    std::uint8_t plane = 0;
    int lowCode = 0;
    int highCode = 65535;
    std::vector<SeedGroup> seedGroups{};
};

/// How many members each generation has, for the window: of a plane's seed words as they are now,
/// an open edit's included. `EngineResult::generationSizes` counts them.
struct CountGenerations {
    std::uint8_t plane = 0;
};

/// Work out at which tolerance each voxel would join a segment (growth/Tolerance.h). It changes
/// nothing. The result has the curve once it is done; from then on the field stands, is told by
/// ProbeVoxels and can be shown, until BeginEdit, SwapBricks, XorBricks, MuteLayers, DropTolerance
/// or another TraceTolerance is carried out or a volume is opened.
struct TraceTolerance {
    ToleranceRule rule;
    /// False: only so much as leaves time for pictures and other commands between. A result without
    /// an error and without a curve then means that asking again goes on from there.
    bool toTheEnd = true;
};
/// No tolerance field is wanted any more. The result is empty.
struct DropTolerance { };

/// Find out what a CutGrowth would take if it began now. It changes nothing. The result tells it
/// (`foreseen`); from then on it can be shown, until BeginEdit, SwapBricks, XorBricks or
/// DropForesight is carried out, another ForeseeCut is answered or a volume is opened.
struct ForeseeCut {
    CutGrowth cut;
    /// False: do not wait for it. A result without an error and without `foreseen` then means that
    /// it is being worked out, beside other commands and pictures: ask again.
    bool toTheEnd = true;
};
/// Nothing foreseen is to be shown any more. The result is empty.
struct DropForesight { };

/// Cast rays into what is seen; integers, so a pick is the same everywhere.
/// A hit names the voxel nearest to the sample found: (P + 2¹⁵) >> 16. Material, inside, carved and
/// Z are those of rule 3 in MaskFrame.h, with the radiation as it stands at this command (what an
/// open stroke has cut so far included). Opacity: each sample inside and not carved adds o =
/// opacityOfCode[Z >> 24] (0 … 65535, per sample) front to back: T = T·(65535 − o) / 65535 from T =
/// 65535, seen when T ≤ 32767. BrightestVoxel: Z over samples inside and not carved.
struct PickVoxels {
    std::vector<PickRay> rays{};
    SeenBy seenBy = SeenBy::Surface;
    int thresholdCode = 0;
    std::vector<std::uint32_t> opacityOfCode{}; ///< 256 entries, only for Opacity
};

using EngineCommandVariant = std::variant<BeginEdit, ExtendEdit, EndEdit, SwapBricks, XorBricks,
    MuteLayers, ReadBricks, ReadSeedWords, ReadCodes, ProbeVoxels, PickVoxels, CountGenerations,
    ProbeSeeds, TraceTolerance, DropTolerance, ForeseeCut, DropForesight>;

/// Any one command; like Edit (core/edits/kinds/Edit.h), its copies are compiled once.
struct EngineCommand : EngineCommandVariant {
    using EngineCommandVariant::variant;
    EngineCommand();
    EngineCommand(const EngineCommand& other);
    EngineCommand(EngineCommand&& other) noexcept;
    EngineCommand& operator=(const EngineCommand& other);
    EngineCommand& operator=(EngineCommand&& other) noexcept;
    ~EngineCommand();
};

// --- Results
// ----------------------------------------------------------------------------------------

/// What a result without an edit of its own says: the rest is zero.
[[nodiscard]] EditStatistics statisticsOf(const ChangeFacts& facts);

/// What became of one command. BeginEdit and ExtendEdit yield none unless they fail.
struct EngineResult {
    Ticket ticket = 0;
    std::optional<Error> error;
    /// Sorted by key, only bricks that differ; an image that is all empty has no bytes.
    std::vector<BrickChange> changes;
    ChangeFacts facts; ///< of these changes; of bricks that were only read none
    EditStatistics statistics;
    std::uint32_t generation = 0; ///< EndEdit of a growth or shrinking: the counter at its end
    bool atClosure = false; ///< EndEdit of a growth: a step was asked for and found nothing
    std::optional<LeakAlarm> alarm{}; ///< EndEdit of a growth: why it stopped
    std::vector<std::uint32_t> seedWords{}; ///< ReadSeedWords
    std::vector<std::uint16_t> codes{}; ///< ReadCodes
    std::vector<ProbedVoxel> probes;
    std::vector<ProbedSeeds> seeds; ///< groups in their order, then the seeds in none, by label;
                                    ///< only those that have voxels
    std::vector<std::optional<glm::ivec3>> picks; ///< one per ray
    std::vector<std::uint32_t> generationSizes; ///< place g: members of generation g; ends with the
                                                ///< last that has any
    std::optional<ToleranceCurve> tolerance{}; ///< TraceTolerance, once it is done
    std::optional<ForeseenCut> foreseen{}; ///< ForeseeCut, once it is done
};

} // namespace core

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
#include "core/sculpt/OutlineCut.h"
#include "core/sculpt/PickRay.h"
#include "core/sculpt/ProtectedLabels.h"
#include "core/sculpt/ShellPeel.h"

#include <bitset>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace core {

/// The number of a submitted command; tickets increase by 1.
using Ticket = std::uint64_t;

// --- Edits as an engine sees them: integers only, everything they read is in them. -------------

/// Remove a label from its plane: every voxel that holds it becomes 0, and every seed word that has
/// it, of a member or a pending seed, becomes seedWord::unvisited. So no growth continues from it;
/// members of other labels keep their generations. Where the label is stored as overwritten
/// (GrowthCommands.h), it is replaced by 0.
struct EraseLabel {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
};

/// Paint a label along a path, or erase it. It changes voxels inside (CapsuleSweep.h, rule 4) with
/// lowCode ≤ code ≤ highCode. The words that "have" a label are those of members and of pending
/// seeds.
///
/// Paint: a voxel at which the plane holds 0, the label or a label in `overwritable` receives the
/// label. The seed words of these voxels change too: with `seeds`, each word that is no member of
/// the label becomes member(0, label, 31); otherwise each word that has another label becomes
/// unvisited. Generation 0 precedes any growth, so a growth continues from there, while shrinking,
/// which removes later generations, leaves what was painted, and no burst treats it as its own.
/// Barriers stay. Erase: a voxel at which the plane holds the label becomes 0, and a seed word that
/// has the label becomes unvisited, so growth may enter it.
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

/// Carve along a path: coverage = max(coverage, cut) with the cut of CapsuleSweep.h, rule 5. To
/// restore, coverage is refilled as described at the end of CutFrame.h, rule 6. Hidden voxels are
/// not changed, and voxels with protected labels (`protectedLabels`) are not carved.
struct CapsuleCut {
    std::uint8_t layer = 0;
    bool restore = false;
    CapsuleFrame frame;
    std::vector<IntegerHalfSpace> hidden{};
    ProtectedLabels protectedLabels{};
};

[[nodiscard]] Result<void> checkSound(const EraseLabel& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const PaintLabel& edit, const BrickGrid& grid);
[[nodiscard]] Result<void> checkSound(const CapsuleCut& edit, const BrickGrid& grid);

/// Of growth: growth/GrowthCommands.h, growth/SeedSpread.h.
using GrowthEdits = TypeList<SeedPlacement, GrowBurst, ShrinkGrowth, CutGrowth, SpreadLabels>;
/// Under the pen. DrillCut, ShellPeel, OutlineCut (sculpt/DrillCut.h and so on): cut into the
/// coverage of one sculpt layer with a mask that is pressed into the volume along the view;
/// LaserCut: along the surface's normals. CapsuleCut, PaintLabel, PaintBarrier: with a brush.
using StrokeEdits =
    TypeList<DrillCut, LaserCut, ShellPeel, OutlineCut, CapsuleCut, PaintLabel, PaintBarrier>;
/// Of whole labels and layers, and of places that are listed. CoverLabel, FoldLayer:
/// sculpt/LayerWrites.h, as LabelWrites, which give labels to voxels.
using WholeEdits = TypeList<EraseLabel, CoverLabel, FoldLayer, BarrierListed>;

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

/// Further samples of the path of a DrillCut or CapsuleCut.
struct DrillPath {
    std::vector<DrillSample> samples;
};

/// Cancels growth steps that were requested and not yet done.
struct GrowPause { };

/// Begins the open growth again, as if it had been rolled back and opened with this burst. Steps
/// requested before are cancelled.
struct GrowAnew {
    GrowBurst burst;
};

/// Further pieces of the path of a PaintLabel, PaintBarrier or CapsuleCut.
struct CapsulePath {
    std::vector<Capsule> capsules;
};

/// Sets the depth of an open ShellPeel, which begins with 0. It may increase or decrease.
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
// empty nor whole; a connectivity other than 6, 18 and 26; a shrinking to more than there is, also
// by ShrinkTo; a segment label of 0; a mask's frame whose pitch, rampHalfWidth or gapSamples is
// below 1; a laser, a brush's frame, what is hidden, a list of labels or places, a growth or groups
// of seeds that are not sound (isSound()); bounds that are not (areSound()); a layer folded into
// itself; a table of opacities of another length than 256; growing from seeds that is not sound
// (isSound()) or with seeds of fewer than two labels; TraceTolerance while a transaction is open,
// by a rule that is not sound (isSound()) or of a label without seeds; PreviewCut while a
// transaction is open, or of a cut that could not begin; a box of codes that is empty or not within
// the volume. ReadBricks, ReadSeedWords, ReadCodes, ProbeVoxels, ProbeSeeds, PickVoxels,
// CountGenerations, DropTolerance and DropCutPreview are served while a transaction is open too. A
// CutGrowth over seeds yields ErrorCode::SeedsStay, one where nothing has grown NothingGrown
// (growth/cut/GrowthCut.h), and so does a PreviewCut of it.

/// Opens a transaction. At most one is open; its ticket identifies it until EndEdit.
struct BeginEdit {
    EngineEdit edit;
};
struct ExtendEdit {
    EngineExtension extension;
};
/// Closes the open transaction; a commit waits for the steps that were requested. The result, which
/// has the ticket of this command, lists every brick that changed since BeginEdit. After a rollback
/// it lists none, its statistics are zero, and voxels and generation are as before.
struct EndEdit {
    Ending ending = Ending::Commit;
};
/// Puts these images in place of the contents of bricks (undo, redo, opening a session). Each key
/// occurs once. The result lists the bricks that differ, with statistics, as for EndEdit. If the
/// guard does not allow it, it is refused with SegmentLocked or SegmentProtected and the label.
struct SwapBricks {
    std::vector<BrickImage> bricks;
    LabelGuard guard{};
};
/// Applies differences to the contents of bricks (undo, redo, "undo only here"). A brick may occur
/// several times. The result is that of SwapBricks.
struct XorBricks {
    std::vector<BrickImage> differences; ///< XOR images, each with its bytes
    LabelGuard guard{};
};
/// Excludes these sculpt layers from the composition of layers from now on: radiation, and with it
/// strokes, picks and pictures, uses the greatest coverage of all others. Their own coverage is
/// kept and can be cut, read and swapped. Opening a volume unmutes all layers. The result is empty.
struct MuteLayers {
    std::bitset<256> muted{};
};
/// Reads bricks; the result lists each with `after` filled and `before` empty, in this order.
struct ReadBricks {
    std::vector<BrickKey> keys;
};
/// Reads the seed words of voxels, in their order (`seedWords`).
struct ReadSeedWords {
    std::vector<glm::ivec3> voxels;
    std::uint8_t plane = 0;
};
/// Reads the codes of a box: 16 bits each, x fastest (`codes`). The engine waits until the box has
/// been copied, so a large box delays frames.
struct ReadCodes {
    VoxelBox box;
};
/// Reads codes, labels and pending seeds at voxels, for readouts, and tolerances if there is a
/// tolerance field.
struct ProbeVoxels {
    std::vector<glm::ivec3> voxels;
    std::uint8_t plane = 0; ///< of the labels
};
/// Computes the statistics around the seeds of a plane's labels: the sums by which a GrowBurst with
/// this interval and these groups would narrow it (GrowLimits) if it opened now.
struct ProbeSeeds {
    std::uint8_t plane = 0;
    int lowCode = 0;
    int highCode = 65535;
    std::vector<SeedGroup> seedGroups{};
};

/// Counts the members of each generation, for the window, in the present seed words of a plane,
/// including those of an open edit. The result is `EngineResult::generationSizes`.
struct CountGenerations {
    std::uint8_t plane = 0;
};

/// Computes at which tolerance each voxel would join a segment (growth/Tolerance.h). It changes
/// nothing. The result contains the curve when it is done. From then on the field exists:
/// ProbeVoxels reads it, and it can be shown, until BeginEdit, SwapBricks, XorBricks, MuteLayers,
/// DropTolerance or another TraceTolerance is carried out, or a volume is opened.
struct TraceTolerance {
    ToleranceRule rule;
    /// False: compute only as much as leaves time for pictures and other commands. A result without
    /// an error and without a curve then means that the next request continues the computation.
    bool toTheEnd = true;
};
/// Discards the tolerance field. The result is empty.
struct DropTolerance { };

/// Computes what a CutGrowth would remove if it began now. It changes nothing. The result
/// contains it (`cutPreview`). From then on it can be shown, until BeginEdit, SwapBricks, XorBricks
/// or DropCutPreview is carried out, another PreviewCut is answered, or a volume is opened.
struct PreviewCut {
    CutGrowth cut;
    /// False: do not wait for it. A result without an error and without `cutPreview` then means
    /// that it is being computed beside other commands and pictures: ask again.
    bool toTheEnd = true;
};
/// Discards what PreviewCut computed. The result is empty.
struct DropCutPreview { };

/// Casts rays to find what is visible; all integers, so a pick is the same on every machine. A hit
/// is the voxel nearest to the sample found: (P + 2¹⁵) >> 16. Material, inside, carved and Z are
/// those of CutFrame.h, rule 3, with the radiation at the time of this command, which includes what
/// an open stroke has cut so far. Opacity: each sample that is inside and not carved adds o =
/// opacityOfCode[Z >> 24] (0 … 65535, per sample) front to back: T = T·(65535 − o) / 65535 from T =
/// 65535; visible when T ≤ 32767. BrightestVoxel: Z over samples that are inside and not carved.
struct PickVoxels {
    std::vector<PickRay> rays{};
    SeenBy seenBy = SeenBy::Surface;
    int thresholdCode = 0;
    std::vector<std::uint32_t> opacityOfCode{}; ///< 256 entries, only for Opacity
};

using EngineCommandVariant = std::variant<BeginEdit, ExtendEdit, EndEdit, SwapBricks, XorBricks,
    MuteLayers, ReadBricks, ReadSeedWords, ReadCodes, ProbeVoxels, PickVoxels, CountGenerations,
    ProbeSeeds, TraceTolerance, DropTolerance, PreviewCut, DropCutPreview>;

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

/// The statistics of a result that has no edit of its own; all others are zero.
[[nodiscard]] EditStatistics statisticsOf(const ChangeFacts& facts);

/// The result of one command. BeginEdit and ExtendEdit have a result only if they fail.
struct EngineResult {
    Ticket ticket = 0;
    std::optional<Error> error;
    /// Sorted by key; only bricks that differ. An image in which all voxels are empty has no bytes.
    std::vector<BrickChange> changes;
    ChangeFacts facts; ///< of these changes; empty for bricks that were only read
    EditStatistics statistics;
    std::uint32_t generation = 0; ///< EndEdit of a growth or shrinking: the generation at its end
    bool atClosure = false; ///< EndEdit of a growth: a step was requested and found nothing to add
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
    std::optional<CutPreview> cutPreview{}; ///< PreviewCut, once it is done
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "ui/base/RowTitleText.h"

#include "core/titles/TitleLanguage.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace ui {

namespace {

/// For translators: %1 and what follows are what the English shows there; of two texts for one and
/// for many the second is told how many there are.
class WindowLanguage : public core::TitleLanguage {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    [[nodiscard]] QString text(
        const core::RowTitle& title, const QStringList& arguments) const override
    {
        return core::filledIn(form(title), arguments);
    }
    [[nodiscard]] QString joiner(core::RowTitleCode code) const override
    {
        return code == core::RowTitleCode::Changes ? tr(" and ") : tr("; ");
    }
    [[nodiscard]] QString comma() const override { return tr(", "); }

private:
    [[nodiscard]] static QString form(const core::RowTitle& title);
};

/// The first argument where it is a count.
int countOf(const core::RowTitle& title)
{
    const auto* count =
        title.arguments.empty() ? nullptr : std::get_if<core::TitleCount>(&title.arguments.front());
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    return count ? int(std::clamp<std::int64_t>(count->count, 0, most)) : 0;
}

QString WindowLanguage::form(const core::RowTitle& title)
{
    using core::RowTitleCode;
    const bool one = core::isOfOne(title);
    const int count = countOf(title);
    switch (title.code) {
    case RowTitleCode::Nothing:
        return {};
    case RowTitleCode::StoredName:
        return QStringLiteral("%1");
    case RowTitleCode::Bricks:
        return one ? tr("1 brick") : tr("%1 bricks", nullptr, count);
    case RowTitleCode::Voxels:
        return one ? tr("1 voxel") : tr("%1 voxels", nullptr, count);
    case RowTitleCode::VoxelsGained:
        return one ? tr("+1 voxel") : tr("+%1 voxels", nullptr, count);
    case RowTitleCode::VoxelsLost:
        return one ? tr("−1 voxel") : tr("−%1 voxels", nullptr, count);
    case RowTitleCode::SeedVoxels:
        return one ? tr("1 seed voxel") : tr("%1 seed voxels", nullptr, count);
    case RowTitleCode::SeedVoxelsGained:
        return one ? tr("+1 seed voxel") : tr("+%1 seed voxels", nullptr, count);
    case RowTitleCode::SeedVoxelsLost:
        return one ? tr("−1 seed voxel") : tr("−%1 seed voxels", nullptr, count);
    case RowTitleCode::FlowIn:
        return tr("+%1 voxels");
    case RowTitleCode::FlowOut:
        return tr("−%1 voxels");
    case RowTitleCode::FlowInAndOut:
        return tr("+%1 −%2 voxels");
    case RowTitleCode::NoVoxel:
        return tr("no voxel");
    case RowTitleCode::Empty:
        return tr("empty");
    case RowTitleCode::Vertices:
        return one ? tr("1 vertex") : tr("%1 vertices", nullptr, count);
    case RowTitleCode::PercentOff:
        return tr("%1 % off");
    case RowTitleCode::Millilitres:
        return tr("%1 mL");
    case RowTitleCode::Millimetres:
        return tr("%1 mm");
    case RowTitleCode::MillimetresDeep:
        return tr("%1 mm deep");
    case RowTitleCode::WithinLimits:
        return tr("within limits");
    case RowTitleCode::SeedStroke:
        return tr("Seed stroke for '%1'");
    case RowTitleCode::MoveSeeds:
        return one ? tr("Move 1 seed of '%2'") : tr("Move %1 seeds of '%2'", nullptr, count);
    case RowTitleCode::TakeSeedsAway:
        return tr("Take seeds of '%1' away");
    case RowTitleCode::VoxelsBecause:
        return one ? tr("1 voxel (%2)") : tr("%1 voxels (%2)", nullptr, count);
    case RowTitleCode::VoxelsOf:
        return one ? tr("%2 of 1 voxel") : tr("%2 of %1 voxels", nullptr, count);
    case RowTitleCode::VoxelsOfBecause:
        return one ? tr("%2 of 1 voxel (%3)") : tr("%2 of %1 voxels (%3)", nullptr, count);
    case RowTitleCode::Reasons:
        return QStringLiteral("%1");
    case RowTitleCode::BelongTo:
        return one ? tr("1 belongs to '%2'") : tr("%1 belong to '%2'", nullptr, count);
    case RowTitleCode::BelongAlready:
        return one ? tr("1 belongs to '%2' already")
                   : tr("%1 belong to '%2' already", nullptr, count);
    case RowTitleCode::SeedsAlready:
        return one ? tr("1 is a seed already") : tr("%1 are seeds already", nullptr, count);
    case RowTitleCode::SeedsOfAnother:
        return one ? tr("1 is a seed of '%2'") : tr("%1 are seeds of '%2'", nullptr, count);
    case RowTitleCode::ShutByBarrier:
        return one ? tr("1 is shut by a barrier") : tr("%1 are shut by a barrier", nullptr, count);
    case RowTitleCode::WereSeedsOf:
        return one ? tr("1 was a seed of '%2'") : tr("%1 were seeds of '%2'", nullptr, count);
    case RowTitleCode::Range:
        return tr("%1 … %2");
    case RowTitleCode::RangeInUnit:
        return tr("%1 … %2 %3");
    case RowTitleCode::Interval:
        return tr("Interval %1");
    case RowTitleCode::GrowInterval:
        return tr("Grow %1");
    case RowTitleCode::GrowAnew:
        return tr("Grow anew from seeds %1");
    case RowTitleCode::Recover:
        return tr("Recover %1");
    case RowTitleCode::WithdrawTo:
        return tr("Withdraw to %1");
    case RowTitleCode::RecoverAndWithdraw:
        return tr("Recover and withdraw %1");
    case RowTitleCode::GrowSteps:
        return one ? tr("Grow 1 step") : tr("Grow %1 steps", nullptr, count);
    case RowTitleCode::GrowSegmentSteps:
        return one ? tr("Grow '%2' 1 step") : tr("Grow '%2' %1 steps", nullptr, count);
    case RowTitleCode::GrowSegmentsSteps:
        return one ? tr("Grow %2 segments 1 step")
                   : tr("Grow %2 segments %1 steps", nullptr, count);
    case RowTitleCode::GrowFromSeeds:
        return tr("Grow from seeds");
    case RowTitleCode::GrowSegmentFromSeeds:
        return tr("Grow '%1' from seeds");
    case RowTitleCode::GrowSegmentsFromSeeds:
        return tr("Grow %1 segments from seeds");
    case RowTitleCode::ShrinkSteps:
        return one ? tr("Shrink 1 step") : tr("Shrink %1 steps", nullptr, count);
    case RowTitleCode::ShrinkToSeeds:
        return tr("Shrink to the seeds");
    case RowTitleCode::ShrinkHere:
        return tr("Shrink here");
    case RowTitleCode::ShrinkHereSteps:
        return one ? tr("Shrink here 1 generation")
                   : tr("Shrink here %1 generations", nullptr, count);
    case RowTitleCode::ShrinkOnlyHere:
        return tr("Shrink only here");
    case RowTitleCode::PlugLeak:
        return tr("Plug leak");
    case RowTitleCode::Barrier:
        return tr("Barrier %1 mm");
    case RowTitleCode::OpenBarrier:
        return tr("Open barrier %1 mm");
    case RowTitleCode::BarrierAroundSurface:
        return tr("Barrier around surface");
    case RowTitleCode::OpenBarrierAroundSurface:
        return tr("Open barrier around surface");
    case RowTitleCode::AddSegment:
        return tr("Add segment '%1'");
    case RowTitleCode::DeleteSegment:
        return tr("Delete segment '%1'");
    case RowTitleCode::MoveSegment:
        return tr("Move segment '%1' to place %2");
    case RowTitleCode::RenameSegment:
        return tr("Rename segment %1 to '%2'");
    case RowTitleCode::CodeSegment:
        return tr("Code segment '%1' as %2");
    case RowTitleCode::CodeIt:
        return tr("code it as %1");
    case RowTitleCode::TakeCode:
        return tr("Take the code from segment '%1'");
    case RowTitleCode::TakeItsCode:
        return tr("take its code away");
    case RowTitleCode::RecolourSegment:
        return tr("Recolour segment '%1'");
    case RowTitleCode::RecolourIt:
        return tr("recolour it");
    case RowTitleCode::LockSegment:
        return tr("Lock segment '%1'");
    case RowTitleCode::LockIt:
        return tr("lock it");
    case RowTitleCode::UnlockSegment:
        return tr("Unlock segment '%1'");
    case RowTitleCode::UnlockIt:
        return tr("unlock it");
    case RowTitleCode::ProtectSegment:
        return tr("Protect segment '%1' from sculpting");
    case RowTitleCode::ProtectIt:
        return tr("protect it from sculpting");
    case RowTitleCode::LetCarveSegment:
        return tr("Let tools carve segment '%1'");
    case RowTitleCode::LetCarveIt:
        return tr("let tools carve it");
    case RowTitleCode::Paint:
        return tr("Paint '%1' %2 mm");
    case RowTitleCode::Erase:
        return tr("Erase '%1' %2 mm");
    case RowTitleCode::PaintAlongEdges:
        return tr("Paint '%1' along edges %2 mm");
    case RowTitleCode::EraseAlongEdges:
        return tr("Erase '%1' along edges %2 mm");
    case RowTitleCode::NudgeOutwards:
        return tr("Nudge '%1' outwards %2 mm");
    case RowTitleCode::NudgeInwards:
        return tr("Nudge '%1' inwards %2 mm");
    case RowTitleCode::FillOutline:
        return tr("Fill an outline with '%1'");
    case RowTitleCode::EraseOutline:
        return tr("Erase '%1' in an outline");
    case RowTitleCode::ImportMask:
        return one ? tr("Import 1 segment of %2") : tr("Import %1 segments of %2", nullptr, count);
    case RowTitleCode::ImportMaskAs:
        return one ? tr("Import 1 segment of %2 as '%3'")
                   : tr("Import %1 segments of %2 as '%3'", nullptr, count);
    case RowTitleCode::InvertSegment:
        return tr("Invert segment '%1'");
    case RowTitleCode::FillHoles:
        return tr("Fill holes of '%1'");
    case RowTitleCode::KeepLargestIsland:
        return tr("Keep the largest island of '%1'");
    case RowTitleCode::RemoveSmallIslands:
        return tr("Remove small islands of '%1'");
    case RowTitleCode::KeepClickedIsland:
        return tr("Keep only one island of '%1'");
    case RowTitleCode::RemoveClickedIsland:
        return tr("Remove one island of '%1'");
    case RowTitleCode::GiveClickedIsland:
        return tr("Give one island of '%1' to '%2'");
    case RowTitleCode::SplitIslands:
        return one ? tr("Split 1 island off '%2'")
                   : tr("Split %1 islands off '%2'", nullptr, count);
    case RowTitleCode::SplitSegment:
        return tr("Split '%1' by a plane");
    case RowTitleCode::MergeSegments:
        return tr("Merge segment '%1' into '%2'");
    case RowTitleCode::SwapSegments:
        return tr("Swap segments '%1' and '%2'");
    case RowTitleCode::GrowByMargin:
        return tr("Grow '%1' by %2 mm");
    case RowTitleCode::ShrinkByMargin:
        return tr("Shrink '%1' by %2 mm");
    case RowTitleCode::GrowBySides:
        return tr("Grow '%1' by margins of up to %2 mm");
    case RowTitleCode::ShrinkBySides:
        return tr("Shrink '%1' by margins of up to %2 mm");
    case RowTitleCode::HollowInside:
        return tr("Hollow '%1', %2 mm inside its border");
    case RowTitleCode::HollowCentred:
        return tr("Hollow '%1', %2 mm along its border");
    case RowTitleCode::HollowOutside:
        return tr("Hollow '%1', %2 mm outside its border");
    case RowTitleCode::OpenShape:
        return tr("Open '%1' by %2 mm");
    case RowTitleCode::CloseShape:
        return tr("Close '%1' by %2 mm");
    case RowTitleCode::SmoothShape:
        return tr("Smooth '%1' by %2 mm");
    case RowTitleCode::WrapShape:
        return tr("Wrap '%1' by %2 mm");
    case RowTitleCode::GaussianShape:
        return tr("Smooth '%1' by a Gaussian of %2 mm");
    case RowTitleCode::JointGaussian:
        return tr("Smooth '%1' and others together by a Gaussian of %2 mm");
    case RowTitleCode::FillBetweenSlices:
        return tr("Fill '%1' between slices");
    case RowTitleCode::MirrorSegment:
        return tr("Mirror '%1'");
    case RowTitleCode::ContourEvolved:
        return tr("Evolve the contour of '%1'");
    case RowTitleCode::ContourFromBubble:
        return tr("Evolve the contour of '%1' from a bubble");
    case RowTitleCode::FloodSlice:
        return tr("Flood fill '%1' in a slice");
    case RowTitleCode::FloodVolume:
        return tr("Flood fill '%1' in 3D");
    case RowTitleCode::FloodEraseSlice:
        return tr("Erase a region of '%1' in a slice");
    case RowTitleCode::FloodEraseVolume:
        return tr("Erase a region of '%1' in 3D");
    case RowTitleCode::ScissorsErase:
        return tr("Scissors erase '%1' inside");
    case RowTitleCode::ScissorsEraseOutside:
        return tr("Scissors erase '%1' outside");
    case RowTitleCode::ScissorsEraseMany:
        return tr("Scissors erase %1 segments inside", nullptr, count);
    case RowTitleCode::ScissorsEraseManyOutside:
        return tr("Scissors erase %1 segments outside", nullptr, count);
    case RowTitleCode::ScissorsFill:
        return tr("Scissors fill '%1' inside");
    case RowTitleCode::ScissorsFillOutside:
        return tr("Scissors fill '%1' outside");
    case RowTitleCode::ThresholdReplace:
        return tr("Threshold '%1' to %2");
    case RowTitleCode::ThresholdAdd:
        return tr("Add %2 to '%1'");
    case RowTitleCode::ThresholdSubtract:
        return tr("Subtract %2 from '%1'");
    case RowTitleCode::SegmentSeen:
        return tr("Segment what is seen as '%1'");
    case RowTitleCode::LayerToSegment:
        return tr("Layer '%1' to segment '%2'");
    case RowTitleCode::AddLayer:
        return tr("Add layer '%1'");
    case RowTitleCode::DeleteLayer:
        return tr("Delete layer '%1'");
    case RowTitleCode::MoveLayer:
        return tr("Move layer '%1' to place %2");
    case RowTitleCode::MergeLayers:
        return tr("Merge layer '%1' into '%2'");
    case RowTitleCode::SegmentToLayer:
        return tr("Segment '%1' to layer '%2'");
    case RowTitleCode::OutsideToLayer:
        return tr("All but segment '%1' to layer '%2'");
    case RowTitleCode::RenameLayer:
        return tr("Rename layer '%1' to '%2'");
    case RowTitleCode::SoloLayer:
        return tr("Solo layer '%1'");
    case RowTitleCode::SoloIt:
        return tr("solo it");
    case RowTitleCode::EndSolo:
        return tr("End solo of layer '%1'");
    case RowTitleCode::EndItsSolo:
        return tr("end its solo");
    case RowTitleCode::MuteLayer:
        return tr("Mute layer '%1'");
    case RowTitleCode::MuteIt:
        return tr("mute it");
    case RowTitleCode::UnmuteLayer:
        return tr("Unmute layer '%1'");
    case RowTitleCode::UnmuteIt:
        return tr("unmute it");
    case RowTitleCode::Drill:
        return tr("Drill %1 mm");
    case RowTitleCode::DrillRate:
        return tr("Drill %1 mm/s");
    case RowTitleCode::RestoreDrill:
        return tr("Restore %1 mm");
    case RowTitleCode::RestoreDrillRate:
        return tr("Restore %1 mm/s");
    case RowTitleCode::Laser:
        return tr("Laser %1 mm");
    case RowTitleCode::LaserRate:
        return tr("Laser %1 mm/s");
    case RowTitleCode::RestoreLaser:
        return tr("Restore laser %1 mm");
    case RowTitleCode::RestoreLaserRate:
        return tr("Restore laser %1 mm/s");
    case RowTitleCode::Peel:
        return tr("Peel %1 mm");
    case RowTitleCode::RestorePeel:
        return tr("Restore peel %1 mm");
    case RowTitleCode::CarveBrush:
        return tr("Carve brush %1 mm");
    case RowTitleCode::RestoreBrush:
        return tr("Restore brush %1 mm");
    case RowTitleCode::CarveScissors:
        return tr("Carve scissors");
    case RowTitleCode::CarveScissorsDeep:
        return tr("Carve scissors %1 mm deep");
    case RowTitleCode::CarveScissorsFirst:
        return tr("Carve scissors through the first layer");
    case RowTitleCode::CarveScissorsDeepFirst:
        return tr("Carve scissors %1 mm deep through the first layer");
    case RowTitleCode::RestoreScissors:
        return tr("Restore scissors");
    case RowTitleCode::RestoreScissorsDeep:
        return tr("Restore scissors %1 mm deep");
    case RowTitleCode::RestoreScissorsFirst:
        return tr("Restore scissors through the first layer");
    case RowTitleCode::RestoreScissorsDeepFirst:
        return tr("Restore scissors %1 mm deep through the first layer");
    case RowTitleCode::UndoOnly:
        return tr("Undo only '%1'");
    case RowTitleCode::UndoOnlySteps:
        return one ? tr("Undo only 1 step") : tr("Undo only %1 steps", nullptr, count);
    case RowTitleCode::RemoveStroke:
        return tr("Remove '%1'");
    case RowTitleCode::ReviseStroke:
        return tr("Revise '%1': %2");
    case RowTitleCode::ReviseAsDrawn:
        return tr("Revise '%1': as it was drawn");
    case RowTitleCode::Changes:
        return QStringLiteral("%1");
    case RowTitleCode::RadiusTo:
        return tr("radius %1 → %2 mm");
    case RowTitleCode::SideTo:
        return tr("side %1 → %2 mm");
    case RowTitleCode::WidthTo:
        return tr("width %1 → %2 mm");
    case RowTitleCode::HeightTo:
        return tr("height %1 → %2 mm");
    case RowTitleCode::OutlineTimes:
        return tr("outline × %1");
    case RowTitleCode::DepthTo:
        return tr("depth %1 → %2 mm");
    case RowTitleCode::SoftEdgeTo:
        return tr("soft edge %1 → %2 mm");
    case RowTitleCode::LayerTo:
        return tr("layer %1 → %2");
    case RowTitleCode::ThroughGaps:
        return tr("through gaps");
    case RowTitleCode::StoppingAtGaps:
        return tr("stopping at gaps");
    case RowTitleCode::Measure:
        return tr("Measure %1 mm");
    case RowTitleCode::RemoveMeasurement:
        return tr("Remove measurement %1 mm");
    case RowTitleCode::RemoveUnknownMeasurement:
        return tr("Remove measurement %1");
    case RowTitleCode::MeasureThat:
        return tr("Measure %1");
    case RowTitleCode::AddNote:
        return tr("Add %1");
    case RowTitleCode::RemoveNote:
        return tr("Remove %1");
    case RowTitleCode::MoveNote:
        return tr("Move %1");
    case RowTitleCode::MoveUnknownMeasurement:
        return tr("Move measurement %1");
    case RowTitleCode::DistanceOf:
        return tr("distance %1 mm");
    case RowTitleCode::AngleOf:
        return tr("angle %1°");
    case RowTitleCode::EllipseOf:
        return tr("ellipse %1");
    case RowTitleCode::RectangleOf:
        return tr("rectangle %1");
    case RowTitleCode::OutlineOf:
        return tr("outline %1");
    case RowTitleCode::BallOf:
        return tr("ball %1");
    case RowTitleCode::Probe:
        return tr("probe");
    case RowTitleCode::Arrow:
        return tr("arrow");
    case RowTitleCode::ArrowTo:
        return tr("arrow '%1'");
    case RowTitleCode::TextThat:
        return tr("text '%1'");
    case RowTitleCode::SquareMillimetres:
        return tr("%1 mm²");
    case RowTitleCode::SquareVoxels:
        return tr("%1 voxels²");
    case RowTitleCode::OfVoxels:
        return tr("%1 voxels");
    case RowTitleCode::Bookmark:
        return tr("Bookmark '%1'");
    case RowTitleCode::RemoveBookmark:
        return tr("Remove bookmark '%1'");
    case RowTitleCode::LiftPiece:
        return tr("Lift '%1' off layer '%2'");
    case RowTitleCode::PastePiece:
        return tr("Paste segment '%1' as piece '%2'");
    case RowTitleCode::RemovePiece:
        return tr("Remove piece '%1'");
    case RowTitleCode::SendPiecesHome:
        return tr("Send all pieces home");
    case RowTitleCode::RenamePiece:
        return tr("Rename piece '%1' to '%2'");
    case RowTitleCode::SendPieceHome:
        return tr("Send piece '%1' home");
    case RowTitleCode::SendItHome:
        return tr("send it home");
    case RowTitleCode::MovePiece:
        return tr("Move piece '%1' %2 mm");
    case RowTitleCode::MoveIt:
        return tr("move it %1 mm");
    case RowTitleCode::TurnPiece:
        return tr("Turn piece '%1' %2°");
    case RowTitleCode::TurnIt:
        return tr("turn it %1°");
    case RowTitleCode::ZoomPiece:
        return tr("Zoom piece '%1' %2×");
    case RowTitleCode::ZoomIt:
        return tr("zoom it %1×");
    case RowTitleCode::SurfaceOf:
        return tr("Surface of '%1'");
    case RowTitleCode::LayCrossingsAnew:
        return tr("Lay crossing parts of the surface anew");
    case RowTitleCode::RemoveSurface:
        return tr("Remove surface");
    case RowTitleCode::FollowMask:
        return tr("Surface follows the mask");
    case RowTitleCode::WriteBack:
        return tr("Write surface back to '%1'");
    case RowTitleCode::SpherePush:
        return tr("Sphere push %1 mm");
    case RowTitleCode::Scrape:
        return tr("Scrape %1 mm");
    case RowTitleCode::DragPoint:
        return tr("Drag point %1 mm");
    case RowTitleCode::SmoothSurface:
        return tr("Smooth surface %1 mm");
    case RowTitleCode::AttractToEdge:
        return tr("Attract to edge %1 mm");
    case RowTitleCode::TemplateOf:
        return one ? tr("Template of 1 contour") : tr("Template of %1 contours", nullptr, count);
    case RowTitleCode::Mark:
        return tr("Mark %1");
    case RowTitleCode::MarkBrush:
        return tr("brush %1 mm");
    case RowTitleCode::Green:
        return tr("green");
    case RowTitleCode::Red:
        return tr("red");
    case RowTitleCode::Yellow:
        return tr("yellow");
    case RowTitleCode::GrowMarks:
        return tr("Grow %1 marks");
    case RowTitleCode::ShrinkMarks:
        return tr("Shrink %1 marks");
    case RowTitleCode::InvertMarks:
        return tr("Invert %1 marks");
    case RowTitleCode::SignOffMarks:
        return tr("Sign off %1 marks");
    case RowTitleCode::SignOffRegion:
        return tr("Sign off %1 region");
    case RowTitleCode::ClearMarks:
        return tr("Clear %1 marks");
    case RowTitleCode::ClearRegion:
        return tr("Clear %1 region");
    case RowTitleCode::DivideAround:
        return tr("Divide around '%1' into chunks");
    case RowTitleCode::DivideByMap:
        return tr("Divide around '%1' into chunks by a probability map");
    case RowTitleCode::ToggleChunks:
        return tr("Toggle chunks of '%1'");
    case RowTitleCode::AddChunks:
        return tr("Add chunks to '%1'");
    case RowTitleCode::TakeChunks:
        return tr("Take chunks from '%1'");
    }
    return {};
}

} // namespace

QString textOf(const core::RowTitle& title)
{
    return core::worded(title, WindowLanguage());
}

QString nameOf(const core::HistoryRow& row)
{
    return row.title ? textOf(*row.title) : row.name;
}

} // namespace ui

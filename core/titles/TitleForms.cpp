// SPDX-License-Identifier: Apache-2.0
#include "core/titles/TitleForms.h"

#include <QHash>
#include <QString>

namespace core {

TitleForm formOf(RowTitleCode code)
{
    switch (code) {
    case RowTitleCode::Nothing:
        return {"nothing", ""};
    case RowTitleCode::StoredName:
        return {"storedName", "%1"};
    case RowTitleCode::Bricks:
        return {"bricks", "%1 bricks", "1 brick"};
    case RowTitleCode::Voxels:
        return {"voxels", "%1 voxels", "1 voxel"};
    case RowTitleCode::VoxelsGained:
        return {"voxelsGained", "+%1 voxels", "+1 voxel"};
    case RowTitleCode::VoxelsLost:
        return {"voxelsLost", "−%1 voxels", "−1 voxel"};
    case RowTitleCode::SeedVoxels:
        return {"seedVoxels", "%1 seed voxels", "1 seed voxel"};
    case RowTitleCode::SeedVoxelsGained:
        return {"seedVoxelsGained", "+%1 seed voxels", "+1 seed voxel"};
    case RowTitleCode::SeedVoxelsLost:
        return {"seedVoxelsLost", "−%1 seed voxels", "−1 seed voxel"};
    case RowTitleCode::FlowIn:
        return {"flowIn", "+%1 voxels"};
    case RowTitleCode::FlowOut:
        return {"flowOut", "−%1 voxels"};
    case RowTitleCode::FlowInAndOut:
        return {"flowInAndOut", "+%1 −%2 voxels"};
    case RowTitleCode::NoVoxel:
        return {"noVoxel", "no voxel"};
    case RowTitleCode::Empty:
        return {"empty", "empty"};
    case RowTitleCode::Vertices:
        return {"vertices", "%1 vertices", "1 vertex"};
    case RowTitleCode::PercentOff:
        return {"percentOff", "%1 % off"};
    case RowTitleCode::Millilitres:
        return {"millilitres", "%1 mL"};
    case RowTitleCode::Millimetres:
        return {"millimetres", "%1 mm"};
    case RowTitleCode::SeedStroke:
        return {"seedStroke", "Seed stroke for '%1'"};
    case RowTitleCode::MoveSeeds:
        return {"moveSeeds", "Move %1 seeds of '%2'", "Move 1 seed of '%2'"};
    case RowTitleCode::TakeSeedsAway:
        return {"takeSeedsAway", "Take seeds of '%1' away"};
    case RowTitleCode::VoxelsBecause:
        return {"voxelsBecause", "%1 voxels (%2)", "1 voxel (%2)"};
    case RowTitleCode::VoxelsOf:
        return {"voxelsOf", "%2 of %1 voxels", "%2 of 1 voxel"};
    case RowTitleCode::VoxelsOfBecause:
        return {"voxelsOfBecause", "%2 of %1 voxels (%3)", "%2 of 1 voxel (%3)"};
    case RowTitleCode::Reasons:
        return {"reasons", "%1"};
    case RowTitleCode::BelongTo:
        return {"belongTo", "%1 belong to '%2'", "1 belongs to '%2'"};
    case RowTitleCode::BelongAlready:
        return {"belongAlready", "%1 belong to '%2' already", "1 belongs to '%2' already"};
    case RowTitleCode::SeedsAlready:
        return {"seedsAlready", "%1 are seeds already", "1 is a seed already"};
    case RowTitleCode::SeedsOfAnother:
        return {"seedsOfAnother", "%1 are seeds of '%2'", "1 is a seed of '%2'"};
    case RowTitleCode::ShutByBarrier:
        return {"shutByBarrier", "%1 are shut by a barrier", "1 is shut by a barrier"};
    case RowTitleCode::WereSeedsOf:
        return {"wereSeedsOf", "%1 were seeds of '%2'", "1 was a seed of '%2'"};
    case RowTitleCode::Range:
        return {"range", "%1 … %2"};
    case RowTitleCode::RangeInUnit:
        return {"rangeInUnit", "%1 … %2 %3"};
    case RowTitleCode::Interval:
        return {"interval", "Interval %1"};
    case RowTitleCode::GrowInterval:
        return {"growInterval", "Grow %1"};
    case RowTitleCode::GrowAnew:
        return {"growAnew", "Grow anew from seeds %1"};
    case RowTitleCode::Recover:
        return {"recover", "Recover %1"};
    case RowTitleCode::WithdrawTo:
        return {"withdrawTo", "Withdraw to %1"};
    case RowTitleCode::RecoverAndWithdraw:
        return {"recoverAndWithdraw", "Recover and withdraw %1"};
    case RowTitleCode::GrowSteps:
        return {"growSteps", "Grow %1 steps", "Grow 1 step"};
    case RowTitleCode::GrowSegmentSteps:
        return {"growSegmentSteps", "Grow '%2' %1 steps", "Grow '%2' 1 step"};
    case RowTitleCode::GrowSegmentsSteps:
        return {"growSegmentsSteps", "Grow %2 segments %1 steps", "Grow %2 segments 1 step"};
    case RowTitleCode::GrowFromSeeds:
        return {"growFromSeeds", "Grow from seeds"};
    case RowTitleCode::GrowSegmentFromSeeds:
        return {"growSegmentFromSeeds", "Grow '%1' from seeds"};
    case RowTitleCode::GrowSegmentsFromSeeds:
        return {"growSegmentsFromSeeds", "Grow %1 segments from seeds"};
    case RowTitleCode::ShrinkSteps:
        return {"shrinkSteps", "Shrink %1 steps", "Shrink 1 step"};
    case RowTitleCode::ShrinkToSeeds:
        return {"shrinkToSeeds", "Shrink to the seeds"};
    case RowTitleCode::ShrinkHere:
        return {"shrinkHere", "Shrink here"};
    case RowTitleCode::ShrinkOnlyHere:
        return {"shrinkOnlyHere", "Shrink only here"};
    case RowTitleCode::PlugLeak:
        return {"plugLeak", "Plug leak"};
    case RowTitleCode::Barrier:
        return {"barrier", "Barrier %1 mm"};
    case RowTitleCode::OpenBarrier:
        return {"openBarrier", "Open barrier %1 mm"};
    case RowTitleCode::BarrierAroundSurface:
        return {"barrierAroundSurface", "Barrier around surface"};
    case RowTitleCode::OpenBarrierAroundSurface:
        return {"openBarrierAroundSurface", "Open barrier around surface"};
    case RowTitleCode::AddSegment:
        return {"addSegment", "Add segment '%1'"};
    case RowTitleCode::DeleteSegment:
        return {"deleteSegment", "Delete segment '%1'"};
    case RowTitleCode::MoveSegment:
        return {"moveSegment", "Move segment '%1' to place %2"};
    case RowTitleCode::RenameSegment:
        return {"renameSegment", "Rename segment %1 to '%2'"};
    case RowTitleCode::CodeSegment:
        return {"codeSegment", "Code segment '%1' as %2"};
    case RowTitleCode::CodeIt:
        return {"codeIt", "code it as %1"};
    case RowTitleCode::TakeCode:
        return {"takeCode", "Take the code from segment '%1'"};
    case RowTitleCode::TakeItsCode:
        return {"takeItsCode", "take its code away"};
    case RowTitleCode::RecolourSegment:
        return {"recolourSegment", "Recolour segment '%1'"};
    case RowTitleCode::RecolourIt:
        return {"recolourIt", "recolour it"};
    case RowTitleCode::LockSegment:
        return {"lockSegment", "Lock segment '%1'"};
    case RowTitleCode::LockIt:
        return {"lockIt", "lock it"};
    case RowTitleCode::UnlockSegment:
        return {"unlockSegment", "Unlock segment '%1'"};
    case RowTitleCode::UnlockIt:
        return {"unlockIt", "unlock it"};
    case RowTitleCode::ProtectSegment:
        return {"protectSegment", "Protect segment '%1' from sculpting"};
    case RowTitleCode::ProtectIt:
        return {"protectIt", "protect it from sculpting"};
    case RowTitleCode::LetCarveSegment:
        return {"letCarveSegment", "Let tools carve segment '%1'"};
    case RowTitleCode::LetCarveIt:
        return {"letCarveIt", "let tools carve it"};
    case RowTitleCode::Paint:
        return {"paint", "Paint '%1' %2 mm"};
    case RowTitleCode::Erase:
        return {"erase", "Erase '%1' %2 mm"};
    case RowTitleCode::ImportMask:
        return {"importMask", "Import %1 segments of %2", "Import 1 segment of %2"};
    case RowTitleCode::ImportMaskAs:
        return {
            "importMaskAs", "Import %1 segments of %2 as '%3'", "Import 1 segment of %2 as '%3'"};
    case RowTitleCode::SegmentSeen:
        return {"segmentSeen", "Segment what is seen as '%1'"};
    case RowTitleCode::LayerToSegment:
        return {"layerToSegment", "Layer '%1' to segment '%2'"};
    case RowTitleCode::AddLayer:
        return {"addLayer", "Add layer '%1'"};
    case RowTitleCode::DeleteLayer:
        return {"deleteLayer", "Delete layer '%1'"};
    case RowTitleCode::MoveLayer:
        return {"moveLayer", "Move layer '%1' to place %2"};
    case RowTitleCode::MergeLayers:
        return {"mergeLayers", "Merge layer '%1' into '%2'"};
    case RowTitleCode::SegmentToLayer:
        return {"segmentToLayer", "Segment '%1' to layer '%2'"};
    case RowTitleCode::RenameLayer:
        return {"renameLayer", "Rename layer '%1' to '%2'"};
    case RowTitleCode::SoloLayer:
        return {"soloLayer", "Solo layer '%1'"};
    case RowTitleCode::SoloIt:
        return {"soloIt", "solo it"};
    case RowTitleCode::EndSolo:
        return {"endSolo", "End solo of layer '%1'"};
    case RowTitleCode::EndItsSolo:
        return {"endItsSolo", "end its solo"};
    case RowTitleCode::MuteLayer:
        return {"muteLayer", "Mute layer '%1'"};
    case RowTitleCode::MuteIt:
        return {"muteIt", "mute it"};
    case RowTitleCode::UnmuteLayer:
        return {"unmuteLayer", "Unmute layer '%1'"};
    case RowTitleCode::UnmuteIt:
        return {"unmuteIt", "unmute it"};
    case RowTitleCode::Drill:
        return {"drill", "Drill %1 mm"};
    case RowTitleCode::DrillRate:
        return {"drillRate", "Drill %1 mm/s"};
    case RowTitleCode::RestoreDrill:
        return {"restoreDrill", "Restore %1 mm"};
    case RowTitleCode::RestoreDrillRate:
        return {"restoreDrillRate", "Restore %1 mm/s"};
    case RowTitleCode::Laser:
        return {"laser", "Laser %1 mm"};
    case RowTitleCode::LaserRate:
        return {"laserRate", "Laser %1 mm/s"};
    case RowTitleCode::RestoreLaser:
        return {"restoreLaser", "Restore laser %1 mm"};
    case RowTitleCode::RestoreLaserRate:
        return {"restoreLaserRate", "Restore laser %1 mm/s"};
    case RowTitleCode::Peel:
        return {"peel", "Peel %1 mm"};
    case RowTitleCode::RestorePeel:
        return {"restorePeel", "Restore peel %1 mm"};
    case RowTitleCode::CarveBrush:
        return {"carveBrush", "Carve brush %1 mm"};
    case RowTitleCode::RestoreBrush:
        return {"restoreBrush", "Restore brush %1 mm"};
    case RowTitleCode::CarveScissors:
        return {"carveScissors", "Carve scissors"};
    case RowTitleCode::CarveScissorsDeep:
        return {"carveScissorsDeep", "Carve scissors %1 mm deep"};
    case RowTitleCode::CarveScissorsFirst:
        return {"carveScissorsFirst", "Carve scissors through the first layer"};
    case RowTitleCode::CarveScissorsDeepFirst:
        return {"carveScissorsDeepFirst", "Carve scissors %1 mm deep through the first layer"};
    case RowTitleCode::RestoreScissors:
        return {"restoreScissors", "Restore scissors"};
    case RowTitleCode::RestoreScissorsDeep:
        return {"restoreScissorsDeep", "Restore scissors %1 mm deep"};
    case RowTitleCode::RestoreScissorsFirst:
        return {"restoreScissorsFirst", "Restore scissors through the first layer"};
    case RowTitleCode::RestoreScissorsDeepFirst:
        return {"restoreScissorsDeepFirst", "Restore scissors %1 mm deep through the first layer"};
    case RowTitleCode::UndoOnly:
        return {"undoOnly", "Undo only '%1'"};
    case RowTitleCode::UndoOnlySteps:
        return {"undoOnlySteps", "Undo only %1 steps", "Undo only 1 step"};
    case RowTitleCode::RemoveStroke:
        return {"removeStroke", "Remove '%1'"};
    case RowTitleCode::ReviseStroke:
        return {"reviseStroke", "Revise '%1': %2"};
    case RowTitleCode::ReviseAsDrawn:
        return {"reviseAsDrawn", "Revise '%1': as it was drawn"};
    case RowTitleCode::Changes:
        return {"changes", "%1"};
    case RowTitleCode::RadiusTo:
        return {"radiusTo", "radius %1 → %2 mm"};
    case RowTitleCode::SideTo:
        return {"sideTo", "side %1 → %2 mm"};
    case RowTitleCode::WidthTo:
        return {"widthTo", "width %1 → %2 mm"};
    case RowTitleCode::HeightTo:
        return {"heightTo", "height %1 → %2 mm"};
    case RowTitleCode::OutlineTimes:
        return {"outlineTimes", "outline × %1"};
    case RowTitleCode::DepthTo:
        return {"depthTo", "depth %1 → %2 mm"};
    case RowTitleCode::SoftEdgeTo:
        return {"softEdgeTo", "soft edge %1 → %2 mm"};
    case RowTitleCode::LayerTo:
        return {"layerTo", "layer %1 → %2"};
    case RowTitleCode::ThroughGaps:
        return {"throughGaps", "through gaps"};
    case RowTitleCode::StoppingAtGaps:
        return {"stoppingAtGaps", "stopping at gaps"};
    case RowTitleCode::Measure:
        return {"measure", "Measure %1 mm"};
    case RowTitleCode::RemoveMeasurement:
        return {"removeMeasurement", "Remove measurement %1 mm"};
    case RowTitleCode::RemoveUnknownMeasurement:
        return {"removeUnknownMeasurement", "Remove measurement %1"};
    case RowTitleCode::Bookmark:
        return {"bookmark", "Bookmark '%1'"};
    case RowTitleCode::RemoveBookmark:
        return {"removeBookmark", "Remove bookmark '%1'"};
    case RowTitleCode::LiftPiece:
        return {"liftPiece", "Lift '%1' off layer '%2'"};
    case RowTitleCode::PastePiece:
        return {"pastePiece", "Paste segment '%1' as piece '%2'"};
    case RowTitleCode::RemovePiece:
        return {"removePiece", "Remove piece '%1'"};
    case RowTitleCode::SendPiecesHome:
        return {"sendPiecesHome", "Send all pieces home"};
    case RowTitleCode::RenamePiece:
        return {"renamePiece", "Rename piece '%1' to '%2'"};
    case RowTitleCode::SendPieceHome:
        return {"sendPieceHome", "Send piece '%1' home"};
    case RowTitleCode::SendItHome:
        return {"sendItHome", "send it home"};
    case RowTitleCode::MovePiece:
        return {"movePiece", "Move piece '%1' %2 mm"};
    case RowTitleCode::MoveIt:
        return {"moveIt", "move it %1 mm"};
    case RowTitleCode::TurnPiece:
        return {"turnPiece", "Turn piece '%1' %2°"};
    case RowTitleCode::TurnIt:
        return {"turnIt", "turn it %1°"};
    case RowTitleCode::ZoomPiece:
        return {"zoomPiece", "Zoom piece '%1' %2×"};
    case RowTitleCode::ZoomIt:
        return {"zoomIt", "zoom it %1×"};
    case RowTitleCode::SurfaceOf:
        return {"surfaceOf", "Surface of '%1'"};
    case RowTitleCode::RemoveSurface:
        return {"removeSurface", "Remove surface"};
    case RowTitleCode::FollowMask:
        return {"followMask", "Surface follows the mask"};
    case RowTitleCode::WriteBack:
        return {"writeBack", "Write surface back to '%1'"};
    case RowTitleCode::SpherePush:
        return {"spherePush", "Sphere push %1 mm"};
    case RowTitleCode::Scrape:
        return {"scrape", "Scrape %1 mm"};
    case RowTitleCode::DragPoint:
        return {"dragPoint", "Drag point %1 mm"};
    case RowTitleCode::SmoothSurface:
        return {"smoothSurface", "Smooth surface %1 mm"};
    case RowTitleCode::AttractToEdge:
        return {"attractToEdge", "Attract to edge %1 mm"};
    case RowTitleCode::TemplateOf:
        return {"templateOf", "Template of %1 contours", "Template of 1 contour"};
    case RowTitleCode::Mark:
        return {"mark", "Mark %1"};
    case RowTitleCode::MarkBrush:
        return {"markBrush", "brush %1 mm"};
    case RowTitleCode::Green:
        return {"green", "green"};
    case RowTitleCode::Red:
        return {"red", "red"};
    case RowTitleCode::Yellow:
        return {"yellow", "yellow"};
    case RowTitleCode::GrowMarks:
        return {"growMarks", "Grow %1 marks"};
    case RowTitleCode::ShrinkMarks:
        return {"shrinkMarks", "Shrink %1 marks"};
    case RowTitleCode::InvertMarks:
        return {"invertMarks", "Invert %1 marks"};
    case RowTitleCode::SignOffMarks:
        return {"signOffMarks", "Sign off %1 marks"};
    case RowTitleCode::SignOffRegion:
        return {"signOffRegion", "Sign off %1 region"};
    case RowTitleCode::ClearMarks:
        return {"clearMarks", "Clear %1 marks"};
    case RowTitleCode::ClearRegion:
        return {"clearRegion", "Clear %1 region"};
    case RowTitleCode::DivideAround:
        return {"divideAround", "Divide around '%1' into chunks"};
    case RowTitleCode::ToggleChunks:
        return {"toggleChunks", "Toggle chunks of '%1'"};
    case RowTitleCode::AddChunks:
        return {"addChunks", "Add chunks to '%1'"};
    case RowTitleCode::TakeChunks:
        return {"takeChunks", "Take chunks from '%1'"};
    }
    return {};
}

const char* joinerOf(RowTitleCode code)
{
    // No comma: behind the last one stands what a row changed.
    return code == RowTitleCode::Changes ? " and " : "; ";
}

std::optional<RowTitleCode> titleCodeFrom(QStringView id)
{
    static const QHash<QString, RowTitleCode> codes = [] {
        QHash<QString, RowTitleCode> all;
        for (std::uint16_t number = 0; formOf(RowTitleCode(number)).id; ++number)
            all.insert(QLatin1String(formOf(RowTitleCode(number)).id), RowTitleCode(number));
        return all;
    }();
    const auto known = codes.constFind(id.toString());
    return known == codes.cend() ? std::nullopt : std::optional(*known);
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/titles/TitleWords.h"

#include <QCoreApplication>

namespace ui {

/// Segments; "it" is the one that was named before.
struct SegmentTitles {
    Q_DECLARE_TR_FUNCTIONS(ui::RowTitleText)

public:
    using Code = core::RowTitleCode;
    static constexpr TitleWords words[] = {
        {Code::AddSegment, QT_TR_NOOP("Add segment '%1'")},
        {Code::DeleteSegment, QT_TR_NOOP("Delete segment '%1'")},
        {Code::MoveSegment, QT_TR_NOOP("Move segment '%1' to place %2")},
        {Code::RenameSegment, QT_TR_NOOP("Rename segment %1 to '%2'")},
        {Code::CodeSegment, QT_TR_NOOP("Code segment '%1' as %2")},
        {Code::CodeIt, QT_TR_NOOP("code it as %1")},
        {Code::TakeCode, QT_TR_NOOP("Take the code from segment '%1'")},
        {Code::TakeItsCode, QT_TR_NOOP("take its code away")},
        {Code::RecolourSegment, QT_TR_NOOP("Recolour segment '%1'")},
        {Code::RecolourIt, QT_TR_NOOP("recolour it")},
        {Code::LockSegment, QT_TR_NOOP("Lock segment '%1'")},
        {Code::LockIt, QT_TR_NOOP("lock it")},
        {Code::UnlockSegment, QT_TR_NOOP("Unlock segment '%1'")},
        {Code::UnlockIt, QT_TR_NOOP("unlock it")},
        {Code::ProtectSegment, QT_TR_NOOP("Protect segment '%1' from sculpting")},
        {Code::ProtectIt, QT_TR_NOOP("protect it from sculpting")},
        {Code::LetCarveSegment, QT_TR_NOOP("Let tools carve segment '%1'")},
        {Code::LetCarveIt, QT_TR_NOOP("let tools carve it")},
        {Code::Paint, QT_TR_NOOP("Paint '%1' %2 mm")},
        {Code::Erase, QT_TR_NOOP("Erase '%1' %2 mm")},
        {Code::PaintAlongEdges, QT_TR_NOOP("Paint '%1' along edges %2 mm")},
        {Code::EraseAlongEdges, QT_TR_NOOP("Erase '%1' along edges %2 mm")},
        {Code::NudgeOutwards, QT_TR_NOOP("Nudge '%1' outwards %2 mm")},
        {Code::NudgeInwards, QT_TR_NOOP("Nudge '%1' inwards %2 mm")},
        {Code::FillOutline, QT_TR_NOOP("Fill an outline with '%1'")},
        {Code::EraseOutline, QT_TR_NOOP("Erase '%1' in an outline")},
        {Code::ImportMask, QT_TR_N_NOOP("Import %1 segments of %2"),
            QT_TR_NOOP("Import 1 segment of %2")},
        {Code::ImportMaskAs, QT_TR_N_NOOP("Import %1 segments of %2 as '%3'"),
            QT_TR_NOOP("Import 1 segment of %2 as '%3'")},
        {Code::InvertSegment, QT_TR_NOOP("Invert segment '%1'")},
        {Code::FillHoles, QT_TR_NOOP("Fill holes of '%1'")},
        {Code::KeepLargestIsland, QT_TR_NOOP("Keep the largest island of '%1'")},
        {Code::RemoveSmallIslands, QT_TR_NOOP("Remove small islands of '%1'")},
        {Code::KeepClickedIsland, QT_TR_NOOP("Keep only one island of '%1'")},
        {Code::RemoveClickedIsland, QT_TR_NOOP("Remove one island of '%1'")},
        {Code::GiveClickedIsland, QT_TR_NOOP("Give one island of '%1' to '%2'")},
        {Code::SplitIslands, QT_TR_N_NOOP("Split %1 islands off '%2'"),
            QT_TR_NOOP("Split 1 island off '%2'")},
        {Code::SplitSegment, QT_TR_NOOP("Split '%1' by a plane")},
        {Code::SplitByCurve, QT_TR_NOOP("Split '%1' by a curve")},
        {Code::SplitByLine, QT_TR_NOOP("Split '%1' along a line")},
        {Code::MergeSegments, QT_TR_NOOP("Merge segment '%1' into '%2'")},
        {Code::SwapSegments, QT_TR_NOOP("Swap segments '%1' and '%2'")},
        {Code::CopySegment, QT_TR_NOOP("Copy segment '%1' as '%2'")},
        {Code::UniteSegments, QT_TR_NOOP("Add voxels of '%1' to '%2'")},
        {Code::SubtractSegment, QT_TR_NOOP("Subtract '%1' from '%2'")},
        {Code::IntersectSegments, QT_TR_NOOP("Intersect '%1' with '%2'")},
        {Code::GrowByMargin, QT_TR_NOOP("Grow '%1' by %2 mm")},
        {Code::ShrinkByMargin, QT_TR_NOOP("Shrink '%1' by %2 mm")},
        {Code::GrowBySides, QT_TR_NOOP("Grow '%1' by margins of up to %2 mm")},
        {Code::ShrinkBySides, QT_TR_NOOP("Shrink '%1' by margins of up to %2 mm")},
        {Code::HollowInside, QT_TR_NOOP("Hollow '%1', %2 mm inside its border")},
        {Code::HollowCentred, QT_TR_NOOP("Hollow '%1', %2 mm along its border")},
        {Code::HollowOutside, QT_TR_NOOP("Hollow '%1', %2 mm outside its border")},
        {Code::OpenShape, QT_TR_NOOP("Open '%1' by %2 mm")},
        {Code::CloseShape, QT_TR_NOOP("Close '%1' by %2 mm")},
        {Code::SmoothShape, QT_TR_NOOP("Smooth '%1' by %2 mm")},
        {Code::WrapShape, QT_TR_NOOP("Wrap '%1' by %2 mm")},
        {Code::GaussianShape, QT_TR_NOOP("Smooth '%1' by a Gaussian of %2 mm")},
        {Code::JointGaussian, QT_TR_NOOP("Smooth '%1' and others together by a Gaussian of %2 mm")},
        {Code::FillBetweenSlices, QT_TR_NOOP("Fill '%1' between slices")},
        {Code::MirrorSegment, QT_TR_NOOP("Mirror '%1'")},
        {Code::ContourEvolved, QT_TR_NOOP("Evolve the contour of '%1'")},
        {Code::ContourFromBubble, QT_TR_NOOP("Evolve the contour of '%1' from a bubble")},
        {Code::ContourErased, QT_TR_NOOP("Erase '%1' by a contour from outside")},
        {Code::ContourErasedFromBubble, QT_TR_NOOP("Erase '%1' by a contour from a bubble")},
        {Code::FloodSlice, QT_TR_NOOP("Flood fill '%1' in a slice")},
        {Code::FloodVolume, QT_TR_NOOP("Flood fill '%1' in 3D")},
        {Code::FloodEraseSlice, QT_TR_NOOP("Erase a region of '%1' in a slice")},
        {Code::FloodEraseVolume, QT_TR_NOOP("Erase a region of '%1' in 3D")},
        {Code::ScissorsErase, QT_TR_NOOP("Scissors erase '%1' inside")},
        {Code::ScissorsEraseOutside, QT_TR_NOOP("Scissors erase '%1' outside")},
        {Code::ScissorsEraseMany, QT_TR_N_NOOP("Scissors erase %1 segments inside"), nullptr, true},
        {Code::ScissorsEraseManyOutside, QT_TR_N_NOOP("Scissors erase %1 segments outside"),
            nullptr, true},
        {Code::ScissorsFill, QT_TR_NOOP("Scissors fill '%1' inside")},
        {Code::ScissorsFillOutside, QT_TR_NOOP("Scissors fill '%1' outside")},
        {Code::ThresholdReplace, QT_TR_NOOP("Threshold '%1' to %2")},
        {Code::ThresholdAdd, QT_TR_NOOP("Add %2 to '%1'")},
        {Code::ThresholdSubtract, QT_TR_NOOP("Subtract %2 from '%1'")},
        {Code::SegmentSeen, QT_TR_NOOP("Segment what is seen as '%1'")},
        {Code::LayerToSegment, QT_TR_NOOP("Layer '%1' to segment '%2'")},
    };
};

} // namespace ui

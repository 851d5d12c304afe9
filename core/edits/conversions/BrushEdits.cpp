// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/engine/HiddenSides.h"
#include "core/edits/engine/SparedSegments.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/segments/PaintStroke.h"

namespace core {

Result<PaintLabel> paintLabel(const PaintStroke& stroke, const Document& document)
{
    const Segment* segment = document.segment(stroke.segment);
    if (!segment)
        return failure(ErrorCode::UnknownSegment, QString::number(stroke.segment),
            QStringLiteral("in field 'paint.segment'"));
    if (segment->locked)
        return failure(ErrorCode::SegmentLocked, segment->name);
    if (stroke.lower && stroke.upper && !(*stroke.lower <= *stroke.upper))
        return failure(ErrorCode::InvalidField, QStringLiteral("paint.upper"),
            QStringLiteral("%1 is below lower, %2").arg(*stroke.upper).arg(*stroke.lower));
    const Volume& volume = document.volumes.front();
    Result<CapsuleFrame> frame =
        capsuleFrame(stroke.path, volume.geometry, QStringLiteral("paint"));
    if (!frame)
        return tl::unexpected(frame.error());
    PaintLabel paint;
    paint.plane = segment->plane;
    paint.label = segment->label;
    paint.erase = stroke.erase;
    paint.seeds = stroke.seeds;
    paint.lowCode = stroke.lower ? volume.encoding.lowestCodeAtLeast(*stroke.lower) : 0;
    paint.highCode = stroke.upper ? volume.encoding.highestCodeAtMost(*stroke.upper)
                                  : VoxelEncoding::codeCount - 1;
    paint.frame = *frame;
    if (stroke.overwriteUnlocked)
        paint.overwritable = document.unlockedLabels(segment->plane);
    return paint;
}

Result<PaintBarrier> paintBarrier(const BarrierStroke& stroke, const Document& document)
{
    const Result<CapsuleFrame> frame =
        capsuleFrame(stroke.path, document.volumes.front().geometry, QStringLiteral("barrier"));
    if (!frame)
        return tl::unexpected(frame.error());
    PaintBarrier barrier;
    barrier.erase = stroke.erase;
    barrier.frame = *frame;
    barrier.frozen = document.lockedLabels(barrier.plane);
    return barrier;
}

Result<CapsuleCut> capsuleCut(const BrushStroke& stroke, const Document& document)
{
    const Result<CapsuleFrame> frame =
        capsuleFrame(stroke.path, document.volumes.front().geometry, QStringLiteral("brush"));
    if (!frame)
        return tl::unexpected(frame.error());
    if (const Result<void> checked =
            checkSpared(stroke.spared, stroke.restore, QStringLiteral("brush"));
        !checked)
        return tl::unexpected(checked.error());
    CapsuleCut cut;
    cut.layer = std::uint8_t(stroke.layer);
    cut.restore = stroke.restore;
    cut.frame = *frame;
    cut.hidden = hiddenHalves(stroke.hidden, document.volumes.front().geometry);
    cut.spared = sparedLabels(stroke.spared, document);
    return cut;
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/PaintStroke.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/open/OpenBrush.h"

#include <algorithm>

namespace core {

using namespace rowWords;

namespace {

/// By how many codes values may differ; codes are evenly spaced (VoxelEncoding.h).
int codesWithin(const VoxelEncoding& encoding, double tolerance)
{
    // A tolerance of whole steps must hold them all, however their values were rounded.
    const double grain = 1e-6 * (encoding.value(1) - encoding.value(0));
    return std::clamp(encoding.highestCodeAtMost(encoding.value(0) + tolerance + grain), 0,
        VoxelEncoding::codeCount - 1);
}

/// A nudge is a disc that takes all under it. Errors: InvalidField.
Result<void> checkTool(const PaintStroke& stroke)
{
    const bool isPlainDisc = stroke.path.shape == BrushPath::Shape::Disc && !stroke.edgeTolerance;
    if (stroke.tool != PaintStroke::Tool::Nudge || isPlainDisc)
        return {};
    return failure(ErrorCode::InvalidField, QStringLiteral("paint.tool"),
        Clause::saying("a nudge is a disc without edgeTolerance"));
}

bool hasPressedTolerance(const PaintStroke& stroke)
{
    return stroke.toleranceByPressure.value_or(false);
}

BrushRule ruleOf(const PaintStroke& stroke)
{
    return {.followsEdges = stroke.edgeTolerance.has_value(),
        .ofTolerance = hasPressedTolerance(stroke)};
}

RowTitleCode titleCode(const PaintStroke& stroke)
{
    if (stroke.tool == PaintStroke::Tool::Nudge)
        return stroke.erase ? RowTitleCode::NudgeInwards : RowTitleCode::NudgeOutwards;
    if (stroke.edgeTolerance)
        return stroke.erase ? RowTitleCode::EraseAlongEdges : RowTitleCode::PaintAlongEdges;
    return stroke.erase ? RowTitleCode::Erase : RowTitleCode::Paint;
}

} // namespace

Result<void> check(const PaintStroke& edit, const Document& document)
{
    return discardValue(paintLabel(edit, document));
}

Result<bool> apply(const PaintStroke&, Document&)
{
    return false;
}

EditEffects effects(const PaintStroke& edit)
{
    return {.task = engineTask<PaintStroke>(),
        .standsOpen = opens<PaintStroke>(),
        .writesTo = edit.segment,
        .fills = {.label = edit.erase ? std::nullopt : std::optional(edit.segment)},
        .boundToStudy = true};
}

Result<PaintLabel> paintLabel(const PaintStroke& stroke, const Document& document)
{
    const Result<const Segment*> unlocked =
        unlockedSegment("paint.segment", stroke.segment, document);
    if (!unlocked)
        return tl::unexpected(unlocked.error());
    const Segment* segment = *unlocked;
    const Volume& volume = document.volumes.front();
    const Result<CodeInterval> codes =
        codesBetween(QStringLiteral("paint"), stroke.lower, stroke.upper, volume.encoding);
    if (!codes)
        return tl::unexpected(codes.error());
    if (stroke.edgeTolerance && !(*stroke.edgeTolerance >= 0.0))
        return failure(ErrorCode::InvalidField, QStringLiteral("paint.edgeTolerance"),
            Clause::saying("%1 is below 0", *stroke.edgeTolerance));
    if (hasPressedTolerance(stroke) && !stroke.edgeTolerance)
        return failure(ErrorCode::InvalidField, QStringLiteral("paint.toleranceByPressure"),
            Clause::saying("needs edgeTolerance"));
    if (const Result<void> tool = checkTool(stroke); !tool)
        return tl::unexpected(tool.error());
    Result<CapsuleFrame> frame =
        capsuleFrame(stroke.path, volume.geometry, QStringLiteral("paint"));
    if (!frame)
        return tl::unexpected(frame.error());
    PaintLabel paint;
    paint.plane = segment->plane;
    paint.label = segment->label;
    paint.erase = stroke.erase;
    paint.seeds = stroke.seeds;
    paint.lowCode = codes->low;
    paint.highCode = codes->high;
    paint.frame = *frame;
    if (stroke.overwriteUnlocked)
        paint.overwritable = document.unlockedLabels(segment->plane);
    if (stroke.edgeTolerance)
        paint.edges = EdgeRule{.start = startVoxel(stroke.path, volume.geometry),
            .tolerance = codesWithin(volume.encoding, *stroke.edgeTolerance)};
    return keepingTo(stroke.editable, document, "paint", std::move(paint));
}

CapsulePath paintPath(const PaintStroke& stroke, const VolumeGeometry& geometry)
{
    return wholeBrushPath(stroke.path, ruleOf(stroke), geometry);
}

Result<EngineEdit> engineEdit(const PaintStroke& edit, const Document& document)
{
    return engineEditFrom(paintLabel(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(PaintStroke& edit)
{
    return std::make_unique<OpenBrush>(edit.path, ruleOf(edit));
}

RowTitle rowTitle(const PaintStroke& stroke, const RowFacts& row)
{
    // What only makes seeds of painted voxels, or takes seeds away, changes no label.
    const std::int64_t voxels = row.statistics.voxelsChanged;
    const std::int64_t seeds = row.facts.seedWordsChanged;
    const bool erases = stroke.erase;
    return {.code = titleCode(stroke),
        .arguments = {segmentName(stroke.segment, row.document), inMm(stroke.path.radiusMm)},
        .then = {voxels > 0
                ? figure(erases ? RowTitleCode::VoxelsLost : RowTitleCode::VoxelsGained, voxels)
                : figure(erases ? RowTitleCode::SeedVoxelsLost : RowTitleCode::SeedVoxelsGained,
                    seeds)}};
}

/// The labels and seed words of the bricks under the brush.
EditDependencies dependencies(const PaintStroke& edit, const DependencyFacts& row)
{
    BrushPath path = edit.path;
    if (hasPressedTolerance(edit))
        path.pressures.reset(); // its radius is whole
    return row.alsoReading(edit.editable, row.labelled(path, row.planeOf(edit.segment)));
}

} // namespace core

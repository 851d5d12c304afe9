// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/ReshapeSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/morphology/MillimetreBall.h"

namespace core {

using namespace rowWords;

namespace {

Error fieldError(const char* field, const QString& reason)
{
    return {ErrorCode::InvalidField,
        {QStringLiteral("reshapeSegment.%1").arg(QLatin1String(field)), reason}};
}

/// A centred shell lies half on either side.
double ballMm(const ReshapeSegment& edit)
{
    constexpr double half = 0.5;
    return edit.shell == ShellPlace::Centred ? half * edit.mm : edit.mm;
}

std::optional<Error> fieldAtFaultIn(const ReshapeSegment& edit, const VolumeGeometry& geometry)
{
    if (edit.shell && edit.operation != ShapeOperation::Hollow)
        return fieldError("shell", QStringLiteral("means nothing where nothing is hollowed out"));
    if (!(edit.mm > 0.0))
        return fieldError("mm", QStringLiteral("is no length"));
    if (ballVoxels(geometry, ballMm(edit)) > mostBallVoxels)
        return fieldError("mm",
            QStringLiteral("%1 mm are more than %2 voxels here").arg(edit.mm).arg(mostBallVoxels));
    return std::nullopt;
}

RowTitleCode titleOf(const ReshapeSegment& edit)
{
    switch (edit.operation) {
    case ShapeOperation::Grow:
        return RowTitleCode::GrowByMargin;
    case ShapeOperation::Shrink:
        return RowTitleCode::ShrinkByMargin;
    case ShapeOperation::Hollow:
        switch (edit.shell.value_or(ShellPlace::Inside)) {
        case ShellPlace::Inside:
            return RowTitleCode::HollowInside;
        case ShellPlace::Centred:
            return RowTitleCode::HollowCentred;
        case ShellPlace::Outside:
            return RowTitleCode::HollowOutside;
        }
        break;
    case ShapeOperation::Open:
        return RowTitleCode::OpenShape;
    case ShapeOperation::Close:
        return RowTitleCode::CloseShape;
    case ShapeOperation::Median:
        break;
    }
    return RowTitleCode::SmoothShape;
}

} // namespace

Result<void> check(const ReshapeSegment& edit, const Document& document)
{
    if (const std::optional<Error> error = fieldAtFaultIn(edit, document.volumes.front().geometry))
        return tl::unexpected(*error);
    if (const auto editable = editableVoxels(edit.editable, document, "reshapeSegment"); !editable)
        return tl::unexpected(editable.error());
    return discardValue(labelTarget({.segment = edit.segment, .name = {}}, false, document));
}

Result<bool> apply(const ReshapeSegment&, Document&)
{
    return false;
}

EditEffects effects(const ReshapeSegment& edit)
{
    return {.task = EditTask::Islands,
        .standsOpen = false,
        .writesTo = edit.segment,
        .fills = {.label = edit.segment},
        .boundToStudy = namesPlaces(edit.editable)};
}

RowTitle rowTitle(const ReshapeSegment& edit, const RowFacts& row)
{
    const Segment* segment = row.document.segment(edit.segment);
    const LabelFlow flow = row.facts.flow(segment ? segment->plane : std::uint8_t(0), edit.segment);
    return {.code = titleOf(edit),
        .arguments = {segmentName(edit.segment, row.document), TitleDigits{edit.mm, 3}},
        .then = {flowTitle(flow.gained, flow.lost)}};
}

/// Every voxel of the plane may decide what is near another.
EditDependencies dependencies(const ReshapeSegment& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

Result<RelabelListed> relabelListed(const ReshapeSegment& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    Result<LabelTarget> target =
        labelTarget({.segment = edit.segment, .name = {}}, false, document);
    if (!target)
        return tl::unexpected(target.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    if (const std::optional<Error> error = fieldAtFaultIn(edit, geometry))
        return tl::unexpected(*error);
    const Result<ShapeChange> change =
        shapeChange(labels, geometry.size, target->label, edit.operation,
            edit.shell.value_or(ShellPlace::Inside), ballOf(geometry, ballMm(edit)), progress);
    if (!change)
        return tl::unexpected(change.error());
    ListedRuns listed(geometry.size);
    listed.add(change->given, RelabelListed::give);
    listed.add(change->taken, RelabelListed::take);
    Result<std::optional<EditableVoxels>> editable =
        editableVoxels(edit.editable, document, "reshapeSegment");
    if (!editable)
        return tl::unexpected(editable.error());
    RelabelListed relabel = listed.relabel(*std::move(target));
    relabel.editable = *std::move(editable);
    return relabel;
}

} // namespace core

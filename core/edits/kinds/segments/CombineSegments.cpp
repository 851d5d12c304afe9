// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CombineSegments.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/open/OpenPreview.h"

#include <algorithm>

namespace core {

using namespace rowWords;

Result<void> check(const CombineSegments& edit, const Document& document)
{
    return discardValue(mapLabels(edit, document));
}

Result<bool> apply(const CombineSegments&, Document&)
{
    return false;
}

EditEffects effects(const CombineSegments& edit)
{
    using How = CombineSegments::How;
    FilledSegments fills = fillsNothing;
    if (edit.how == How::Merge || edit.how == How::Swap || edit.how == How::Union)
        fills.label = edit.segment;
    if (edit.how == How::Swap)
        fills.other = edit.with;
    return {.task = engineTask<CombineSegments>(),
        .standsOpen = opens<CombineSegments>(),
        .writesTo = edit.segment,
        .fills = fills,
        .boundToStudy = namesPlaces(edit.editable)};
}

namespace {

tl::unexpected<Error> wrongWith(const Clause& reason)
{
    return failure(ErrorCode::InvalidField, QStringLiteral("combineSegments.with"), reason);
}

/// Within one label plane: both are written.
Result<MapLabels> exchange(
    const CombineSegments& edit, const Segment& segment, const Document& document)
{
    const Result<const Segment*> other =
        unlockedSegment("combineSegments.with", edit.with, document);
    if (!other)
        return tl::unexpected(other.error());
    if (segment.plane != (*other)->plane)
        return wrongWith(Clause::saying("lies on another label plane than the segment"));
    MapLabels map{.plane = segment.plane};
    map.becomes[(*other)->label] = segment.label;
    if (edit.how == CombineSegments::How::Swap)
        map.becomes[segment.label] = (*other)->label;
    return keepingTo(edit.editable, document, "combineSegments", std::move(map));
}

/// By a segment of another plane: what the operation asks of it is asked as of an editable range.
Result<MapLabels> setOperation(
    const CombineSegments& edit, const Segment& segment, const Document& document)
{
    const Segment* other = document.segment(edit.with);
    if (!other)
        return failure(ErrorCode::UnknownSegment, QString::number(edit.with),
            Clause::saying("in field 'combineSegments.with'"));
    if (segment.plane == other->plane)
        return wrongWith(Clause::saying(
            "lies on the label plane of the segment, so no voxel belongs to both of them"));
    EditableRange range = edit.editable.value_or(EditableRange());
    if (edit.how == CombineSegments::How::Intersect) {
        if (!range.outside)
            range.outside.emplace();
        if (std::find(range.outside->begin(), range.outside->end(), edit.with)
            == range.outside->end())
            range.outside->push_back(edit.with);
    } else if (range.inside) {
        return failure(ErrorCode::InvalidField, QStringLiteral("combineSegments.editable.inside"),
            Clause::saying("cannot be asked as well: what changes lies inside the other segment"));
    } else {
        range.inside = {edit.with};
    }
    MapLabels map{.plane = segment.plane};
    if (edit.how == CombineSegments::How::Union)
        map.becomes[0] = segment.label;
    else
        map.becomes[segment.label] = 0;
    return keepingTo(range, document, "combineSegments", std::move(map));
}

} // namespace

Result<MapLabels> mapLabels(const CombineSegments& edit, const Document& document)
{
    using How = CombineSegments::How;
    const Result<const Segment*> segment =
        unlockedSegment("combineSegments.segment", edit.segment, document);
    if (!segment)
        return tl::unexpected(segment.error());
    if (edit.segment == edit.with)
        return wrongWith(Clause::saying("is the segment itself"));
    if (edit.how == How::Merge || edit.how == How::Swap)
        return exchange(edit, **segment, document);
    return setOperation(edit, **segment, document);
}

Result<EngineEdit> engineEdit(const CombineSegments& edit, const Document& document)
{
    return engineEditFrom(mapLabels(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(CombineSegments&)
{
    return std::make_unique<OpenPreview>();
}

RowTitle rowTitle(const CombineSegments& edit, const RowFacts& row)
{
    const LabelFlow flow = row.flowOf(edit.segment);
    const QString own = segmentName(edit.segment, row.document);
    const QString other = segmentName(edit.with, row.document);
    const RowTitle changed = flowTitle(flow.gained, flow.lost);
    switch (edit.how) {
    case CombineSegments::How::Merge:
        break;
    case CombineSegments::How::Swap:
        return {.code = RowTitleCode::SwapSegments, .arguments = {own, other}, .then = {changed}};
    case CombineSegments::How::Union:
        return {.code = RowTitleCode::UniteSegments, .arguments = {other, own}, .then = {changed}};
    case CombineSegments::How::Subtract:
        return {
            .code = RowTitleCode::SubtractSegment, .arguments = {other, own}, .then = {changed}};
    case CombineSegments::How::Intersect:
        return {
            .code = RowTitleCode::IntersectSegments, .arguments = {own, other}, .then = {changed}};
    }
    return {.code = RowTitleCode::MergeSegments, .arguments = {other, own}, .then = {changed}};
}

/// The voxels of both segments decide, and the seeds that lie there.
EditDependencies dependencies(const CombineSegments& edit, const DependencyFacts& row)
{
    EditDependencies all =
        row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
    all.labelPlanes.set(row.planeOf(edit.with));
    return all;
}

} // namespace core

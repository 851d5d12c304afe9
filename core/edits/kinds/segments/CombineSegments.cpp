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
    return discardValue(engineEdit(edit, document));
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

tl::unexpected<Error> insideAsWell()
{
    return failure(ErrorCode::InvalidField, QStringLiteral("combineSegments.editable.inside"),
        Clause::saying("cannot be asked as well: what changes lies inside the other segment"));
}

/// Whether both planes of two segments are written.
bool mergesPlanes(const CombineSegments& edit, const Document& document)
{
    const Segment* segment = document.segment(edit.segment);
    const Segment* other = document.segment(edit.with);
    return edit.how == CombineSegments::How::Merge && segment && other
        && segment->plane != other->plane;
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
        return wrongWith(Clause::saying("lies on another label plane than the segment, and in each "
                                        "plane others may be in the way"));
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
        return insideAsWell();
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

Result<MapPlanes> mapPlanes(const CombineSegments& edit, const Document& document)
{
    const Result<const Segment*> segment =
        unlockedSegment("combineSegments.segment", edit.segment, document);
    if (!segment)
        return tl::unexpected(segment.error());
    const Result<const Segment*> other =
        unlockedSegment("combineSegments.with", edit.with, document);
    if (!other)
        return tl::unexpected(other.error());
    EditableRange range = edit.editable.value_or(EditableRange());
    if (range.inside)
        return insideAsWell();
    const std::vector<int> outside = range.outside.value_or(std::vector<int>());
    if (std::find(outside.begin(), outside.end(), edit.segment) != outside.end())
        return failure(ErrorCode::InvalidField, QStringLiteral("combineSegments.editable.outside"),
            Clause::saying("cannot name the segment: what it receives lies in it from then on"));
    // First the segment takes what it can have, then the other loses what the segment has.
    MapLabels taken{.plane = (*segment)->plane};
    taken.becomes[0] = (*segment)->label;
    MapLabels left{.plane = (*other)->plane};
    left.becomes[(*other)->label] = 0;
    range.inside = {edit.with};
    Result<MapLabels> first = keepingTo(range, document, "combineSegments", std::move(taken));
    if (!first)
        return tl::unexpected(first.error());
    range.inside = {edit.segment};
    Result<MapLabels> second = keepingTo(range, document, "combineSegments", std::move(left));
    if (!second)
        return tl::unexpected(second.error());
    return MapPlanes{.planes = {*std::move(first), *std::move(second)}};
}

Result<EngineEdit> engineEdit(const CombineSegments& edit, const Document& document)
{
    if (mergesPlanes(edit, document))
        return engineEditFrom(mapPlanes(edit, document));
    return engineEditFrom(mapLabels(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(CombineSegments&)
{
    return std::make_unique<OpenPreview>();
}

namespace {

/// How many voxels stay with the other segment when it is merged into one of another plane.
std::int64_t keptBy(const CombineSegments& edit, const RowFacts& row)
{
    return mergesPlanes(edit, row.document)
        ? row.document.segment(edit.with)->voxels - row.flowOf(edit.with).lost
        : 0;
}

} // namespace

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
    RowTitle merged{.code = RowTitleCode::MergeSegments,
        .arguments = {other, own},
        .then = {figure(RowTitleCode::FlowIn, flow.gained)}};
    if (const std::int64_t kept = keptBy(edit, row); kept > 0)
        merged.then.push_back(figure(RowTitleCode::VoxelsStay, kept));
    return merged;
}

/// The voxels of both segments decide, and the seeds that lie there.
EditDependencies dependencies(const CombineSegments& edit, const DependencyFacts& row)
{
    dependsOn::Plane written{.plane = row.planeOf(edit.segment)};
    if (mergesPlanes(edit, row.document))
        written.plane.reset(); // it writes to two planes
    EditDependencies all = row.alsoReading(edit.editable, written);
    all.labelPlanes.set(row.planeOf(edit.with));
    return all;
}

} // namespace core

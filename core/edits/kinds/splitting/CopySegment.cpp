// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/CopySegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/kinds/splitting/SplitParts.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <algorithm>

namespace core {

using namespace rowWords;

namespace {

tl::unexpected<Error> wrongCopy(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField, QLatin1String(field), reason);
}

Result<const Segment*> copiedSegment(const CopySegment& edit, const Document& document)
{
    const Segment* segment = document.segment(edit.segment);
    if (!segment)
        return failure(ErrorCode::UnknownSegment, QString::number(edit.segment),
            Clause::saying("in field 'copySegment.segment'"));
    return segment;
}

/// The range of the edit, and only where the segment is.
Result<EditableRange> withinSegment(const CopySegment& edit)
{
    EditableRange range = edit.editable.value_or(EditableRange());
    // All of the segment lies inside, whatever else is listed.
    if (range.inside
        && std::find(range.inside->begin(), range.inside->end(), edit.segment)
            == range.inside->end())
        return wrongCopy("copySegment.editable.inside",
            Clause::saying("cannot be asked as well: what is copied lies inside the segment"));
    range.inside = {edit.segment};
    return range;
}

} // namespace

Result<void> check(const CopySegment& edit, const Document& document)
{
    if (const Result<void> applied = checkApplied(edit, document); !applied)
        return applied;
    const Result<EditableRange> range = withinSegment(edit);
    if (!range)
        return tl::unexpected(range.error());
    return discardValue(editableVoxels(*range, document, "copySegment"));
}

Result<bool> apply(const CopySegment& edit, Document& document)
{
    const Result<const Segment*> segment = copiedSegment(edit, document);
    if (!segment)
        return tl::unexpected(segment.error());
    const std::uint8_t own = (*segment)->plane;
    if (edit.plane == own)
        return wrongCopy("copySegment.plane",
            Clause::saying("is the label plane of the segment, so no voxel can belong to both"));
    if (roomForSegments(document) == 0)
        return wrongCopy("copySegment",
            Clause::saying("a session has room for %1 segments, those deleted included",
                int(document.lastLabelGiven())));
    const int beside = own == 0 ? 1 : 0;
    const int plane = edit.plane.value_or(document.planeWithoutSegments().value_or(beside));
    document.segments.push_back({.label = std::uint8_t(document.lastLabelGiven() + 1),
        .plane = std::uint8_t(plane),
        .name = edit.name,
        .rgb = edit.rgb,
        .code = CodedConcept((*segment)->code)});
    return true;
}

EditEffects effects(const CopySegment& edit)
{
    return {.task = EditTask::Islands,
        .standsOpen = false,
        .changes = DocumentChange::What::Segments,
        .takesVoxelsOrNothing = true,
        .fills = {.label = std::nullopt,
            .added = edit.plane ? AddedSegments::Known : AddedSegments::UnknownPlane},
        .boundToStudy = namesPlaces(edit.editable)};
}

Result<int> planeOfCopy(
    const CopySegment& edit, const Document& document, std::span<const std::uint8_t> taken)
{
    const Result<const Segment*> segment = copiedSegment(edit, document);
    if (!segment)
        return tl::unexpected(segment.error());
    for (const std::uint8_t plane : document.labelPlanes()) {
        const bool isTaken = std::find(taken.begin(), taken.end(), plane) != taken.end();
        if (plane != (*segment)->plane && !isTaken)
            return plane;
    }
    if (const std::optional<std::uint8_t> plane = document.planeWithoutSegments())
        return *plane;
    return wrongCopy("copySegment",
        Clause::saying("a session has at most %1 label planes, and in each of them other segments "
                       "have voxels of '%2'",
            mostLabelPlanes, (*segment)->name));
}

Result<MapLabels> mapLabels(const CopySegment& edit, const Document& document)
{
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    const Result<EditableRange> range = withinSegment(edit);
    if (!range)
        return tl::unexpected(range.error());
    MapLabels map{.plane = std::uint8_t(edit.plane.value())};
    map.becomes[0] = std::uint8_t(document.lastLabelGiven() + 1);
    return keepingTo(*range, document, "copySegment", std::move(map));
}

/// "Copy segment 'Liver' as 'Liver copy', +3 210 voxels"
RowTitle rowTitle(const CopySegment& edit, const RowFacts& row)
{
    const LabelFlow flow =
        row.facts.flow(std::uint8_t(edit.plane.value_or(0)), row.document.lastLabelGiven() + 1);
    return {.code = RowTitleCode::CopySegment,
        .arguments = {segmentName(edit.segment, row.document), edit.name},
        .then = {flowTitle(flow.gained, flow.lost)}};
}

/// The voxels of the segment decide, and which ones are free in the plane of the copy.
EditDependencies dependencies(const CopySegment& edit, const DependencyFacts& row)
{
    const std::optional<std::uint8_t> plane =
        edit.plane ? std::optional(std::uint8_t(*edit.plane)) : std::nullopt;
    EditDependencies all = row.alsoReading(edit.editable, dependsOn::Plane{.plane = plane});
    all.labelPlanes.set(row.planeOf(edit.segment));
    return all;
}

} // namespace core

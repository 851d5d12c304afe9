// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CombineSegments.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"

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
    const bool swaps = edit.how == CombineSegments::How::Swap;
    return {.task = engineTask<CombineSegments>(),
        .standsOpen = false,
        .writesTo = edit.segment,
        .fills = {.label = edit.segment, .other = swaps ? std::optional(edit.with) : std::nullopt},
        .boundToStudy = namesPlaces(edit.editable)};
}

Result<MapLabels> mapLabels(const CombineSegments& edit, const Document& document)
{
    const Result<const Segment*> segment =
        unlockedSegment("combineSegments.segment", edit.segment, document);
    if (!segment)
        return tl::unexpected(segment.error());
    const Result<const Segment*> other =
        unlockedSegment("combineSegments.with", edit.with, document);
    if (!other)
        return tl::unexpected(other.error());
    if (edit.segment == edit.with)
        return failure(ErrorCode::InvalidField, QStringLiteral("combineSegments.with"),
            Clause::saying("is the segment itself"));
    if ((*segment)->plane != (*other)->plane)
        return failure(ErrorCode::InvalidField, QStringLiteral("combineSegments.with"),
            Clause::saying("lies on another label plane than the segment"));
    MapLabels map{.plane = (*segment)->plane};
    map.becomes[(*other)->label] = (*segment)->label;
    if (edit.how == CombineSegments::How::Swap)
        map.becomes[(*segment)->label] = (*other)->label;
    return keepingTo(edit.editable, document, "combineSegments", std::move(map));
}

Result<EngineEdit> engineEdit(const CombineSegments& edit, const Document& document)
{
    return engineEditFrom(mapLabels(edit, document));
}

RowTitle rowTitle(const CombineSegments& edit, const RowFacts& row)
{
    const LabelFlow flow = row.flowOf(edit.segment);
    const QString own = segmentName(edit.segment, row.document);
    const QString other = segmentName(edit.with, row.document);
    RowTitle title{.code = RowTitleCode::MergeSegments,
        .arguments = {other, own},
        .then = {flowTitle(flow.gained, flow.lost)}};
    if (edit.how == CombineSegments::How::Swap) {
        title.code = RowTitleCode::SwapSegments;
        title.arguments = {own, other};
    }
    return title;
}

/// The voxels of both segments decide, and the seeds that lie there.
EditDependencies dependencies(const CombineSegments& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

} // namespace core

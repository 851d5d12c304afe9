// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/RemoveSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"

namespace core {

using namespace rowWords;

Result<void> check(const RemoveSegment& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const RemoveSegment& edit, Document& document)
{
    const Segment* segment = document.segment(edit.segment);
    if (!segment)
        return unknownSegment(edit.segment);
    if (segment->locked)
        return failure(ErrorCode::SegmentLocked, segment->name);
    document.greatestRemovedLabel = std::max(document.greatestRemovedLabel, edit.segment);
    removePieces(document, [&](const Piece& piece) { return piece.segment == edit.segment; });
    if (document.surface && document.surface->segment == edit.segment)
        document.surface.reset();
    if (document.chunks && document.chunks->segment == edit.segment) {
        document.greatestRemovedChunks = document.chunks->id;
        document.chunks.reset();
    }
    document.segments.erase(document.segments.begin() + (segment - document.segments.data()));
    return true;
}

EditEffects effects(const RemoveSegment&)
{
    return {.task = engineTask<RemoveSegment>(),
        .standsOpen = false,
        .changes = DocumentChange::What::Segments,
        .fills = fillsNothing};
}

Result<EraseLabel> eraseLabel(const RemoveSegment& edit, const Document& document)
{
    const Result<const Segment*> unlocked =
        unlockedSegment("removeSegment.segment", edit.segment, document);
    if (!unlocked)
        return tl::unexpected(unlocked.error());
    const Segment* segment = *unlocked;
    return EraseLabel{.plane = segment->plane, .label = segment->label};
}

Result<EngineEdit> engineEdit(const RemoveSegment& edit, const Document& document)
{
    return engineEditFrom(eraseLabel(edit, document));
}

RowTitle rowTitle(const RemoveSegment& edit, const RowFacts& row)
{
    const std::int64_t seeds = row.facts.seedWordsChanged;
    RowTitle lost{.code = RowTitleCode::Empty};
    if (row.statistics.voxelsChanged > 0)
        lost = figure(RowTitleCode::VoxelsLost, row.statistics.voxelsChanged);
    else if (seeds > 0)
        lost = figure(RowTitleCode::SeedVoxelsLost, seeds);
    return {.code = RowTitleCode::DeleteSegment,
        .arguments = {segmentName(edit.segment, row.document)},
        .then = {lost}};
}

/// As of a growth, since its label must not come back without it; in all planes, since a segment
/// that is gone no longer says in which it lay.
EditDependencies dependencies(const RemoveSegment&, const DependencyFacts&)
{
    return dependsOn::Plane{};
}

} // namespace core

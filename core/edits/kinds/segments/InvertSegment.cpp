// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/InvertSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/open/OpenPreview.h"

namespace core {

using namespace rowWords;

Result<void> check(const InvertSegment& edit, const Document& document)
{
    return discardValue(mapLabels(edit, document));
}

Result<bool> apply(const InvertSegment&, Document&)
{
    return false;
}

EditEffects effects(const InvertSegment& edit)
{
    return {.task = engineTask<InvertSegment>(),
        .standsOpen = opens<InvertSegment>(),
        .writesTo = edit.segment,
        .fills = {.label = edit.segment},
        .boundToStudy = namesPlaces(edit.editable)};
}

Result<MapLabels> mapLabels(const InvertSegment& edit, const Document& document)
{
    const Result<const Segment*> unlocked =
        unlockedSegment("invertSegment.segment", edit.segment, document);
    if (!unlocked)
        return tl::unexpected(unlocked.error());
    const Segment* segment = *unlocked;
    MapLabels map{.plane = segment->plane};
    map.becomes[0] = segment->label;
    map.becomes[segment->label] = 0;
    return keepingTo(edit.editable, document, "invertSegment", std::move(map));
}

Result<EngineEdit> engineEdit(const InvertSegment& edit, const Document& document)
{
    return engineEditFrom(mapLabels(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(InvertSegment&)
{
    return std::make_unique<OpenPreview>();
}

RowTitle rowTitle(const InvertSegment& edit, const RowFacts& row)
{
    return segmentChanged(RowTitleCode::InvertSegment, edit.segment, row);
}

/// What other segments hold decides, too, and whose seeds lie where.
EditDependencies dependencies(const InvertSegment& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

} // namespace core

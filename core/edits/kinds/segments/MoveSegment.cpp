// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/MoveSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"

namespace core {

Result<void> check(const MoveSegment& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const MoveSegment& edit, Document& document)
{
    const Segment* segment = document.segment(edit.segment);
    if (!segment)
        return unknownSegment(edit.segment);
    std::vector<Segment>& segments = document.segments;
    return moveTo(segments, segments.begin() + (segment - segments.data()), edit.place);
}

EditEffects effects(const MoveSegment&)
{
    return documentEffects(DocumentChange::What::Segments);
}

RowTitle rowTitle(const MoveSegment& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::MoveSegment,
        .arguments = {rowWords::segmentName(edit.segment, row.document), TitleNumber{edit.place}}};
}

EditDependencies dependencies(const MoveSegment&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

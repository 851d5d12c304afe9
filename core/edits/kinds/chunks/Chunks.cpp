// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/Chunks.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/chunks/ChunkVoxels.h"

namespace core {

using namespace rowWords;

Result<void> check(const Chunks& edit, const Document& document)
{
    if (const Result<void> applied = checkApplied(edit, document); !applied)
        return applied;
    if (!edit.owners)
        return {};
    return discardValue(ownedBox(edit, document.volumes.front().geometry));
}

/// Whether it divides otherwise than before only the session can tell, who has the rows.
Result<bool> apply(const Chunks& edit, Document& document)
{
    if (!document.segment(edit.segment))
        return unknownSegment(edit.segment);
    document.chunks = {
        .id = document.lastChunksGiven() + 1, .segment = edit.segment, .marginMm = edit.marginMm};
    return true;
}

EditEffects effects(const Chunks& edit)
{
    return {.task = EditTask::Chunks,
        .standsOpen = false,
        .changes = DocumentChange::What::Chunks,
        .onlyDocument = true,
        .boundToStudy = edit.owners.has_value()};
}

RowTitle rowTitle(const Chunks& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::DivideAround,
        .arguments = {segmentName(edit.segment, row.document)},
        .then = {{.code = RowTitleCode::Millimetres, .arguments = {inMm(edit.marginMm)}}}};
}

EditReach reach(const Chunks&, const ReachFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

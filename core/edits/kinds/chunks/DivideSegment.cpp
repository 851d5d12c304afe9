// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/DivideSegment.h"

#include "core/chunks/ProbabilityMap.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/chunks/ChunkVoxels.h"

namespace core {

using namespace rowWords;

Result<void> check(const DivideSegment& edit, const Document& document)
{
    if (const Result<void> applied = checkApplied(edit, document); !applied)
        return applied;
    if (edit.probabilityFile)
        return failure(ErrorCode::InvalidField, QStringLiteral("chunks.probabilityFile"),
            Clause::saying("its file has not been read"));
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    // Whether it can be unpacked shows where it is, beside the session's thread.
    if (edit.probabilities && !ProbabilityMap::isOf(*edit.probabilities, geometry.voxelCount()))
        return failure(ErrorCode::InvalidField, QStringLiteral("chunks.probabilities"),
            Clause::saying("the probability map is damaged, or of another volume"));
    if (!edit.owners)
        return {};
    return discardValue(ownedBox(edit, geometry));
}

/// Whether it divides otherwise than before only the session can tell, who has the rows.
Result<bool> apply(const DivideSegment& edit, Document& document)
{
    if (!document.segment(edit.segment))
        return unknownSegment(edit.segment);
    document.chunks = {
        .id = document.lastChunksGiven() + 1, .segment = edit.segment, .marginMm = edit.marginMm};
    return true;
}

EditEffects effects(const DivideSegment& edit)
{
    return {.task = EditTask::Chunks,
        .standsOpen = false,
        .changes = DocumentChange::What::Chunks,
        .onlyDocument = true,
        .fills = fillsNothing,
        .boundToStudy = edit.owners.has_value() || edit.probabilities.has_value()};
}

RowTitle rowTitle(const DivideSegment& edit, const RowFacts& row)
{
    return {.code = edit.probabilities ? RowTitleCode::DivideByMap : RowTitleCode::DivideAround,
        .arguments = {segmentName(edit.segment, row.document)},
        .then = {{.code = RowTitleCode::Millimetres, .arguments = {inMm(edit.marginMm)}}}};
}

EditDependencies dependencies(const DivideSegment&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

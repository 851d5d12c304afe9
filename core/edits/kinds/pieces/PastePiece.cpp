// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/pieces/PastePiece.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/pieces/AppendPiece.h"

namespace core {

using namespace rowWords;

Result<void> check(const PastePiece& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const PastePiece& edit, Document& document)
{
    if (!document.segment(edit.segment))
        return unknownSegment(edit.segment);
    return appendPiece(
        {.name = edit.name, .segment = edit.segment, .pivotLps = edit.pivotLps, .pose = edit.pose},
        "pastePiece", document);
}

EditEffects effects(const PastePiece& edit)
{
    return documentEffects(DocumentChange::What::Pieces, edit.pivotLps.has_value());
}

RowTitle rowTitle(const PastePiece& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::PastePiece,
        .arguments = {segmentName(edit.segment, row.document), edit.name}};
}

EditDependencies dependencies(const PastePiece&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

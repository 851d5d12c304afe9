// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/ChangeMarks.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/kinds/surface/parts/SurfaceParts.h"

namespace core {

using namespace rowWords;

namespace {

RowTitleCode titleCode(const ChangeMarks& change)
{
    switch (change.way) {
    case ChangeMarks::Way::Grow:
        return RowTitleCode::GrowMarks;
    case ChangeMarks::Way::Shrink:
        return RowTitleCode::ShrinkMarks;
    case ChangeMarks::Way::Invert:
        return RowTitleCode::InvertMarks;
    case ChangeMarks::Way::Accept:
        return change.nearLps ? RowTitleCode::SignOffRegion : RowTitleCode::SignOffMarks;
    case ChangeMarks::Way::Clear:
        break;
    }
    return change.nearLps ? RowTitleCode::ClearRegion : RowTitleCode::ClearMarks;
}

} // namespace

Result<void> check(const ChangeMarks& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const ChangeMarks& edit, Document& document)
{
    if (edit.mark == SurfaceMark::Yellow)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.mark"),
            Clause::saying("yellow is what is not marked"));
    using Way = ChangeMarks::Way;
    if (edit.way == Way::Accept && edit.mark != SurfaceMark::Red)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.mark"),
            Clause::saying("only what is red can be accepted"));
    if (edit.nearLps && edit.way != Way::Clear && edit.way != Way::Accept)
        return failure(ErrorCode::InvalidField, QStringLiteral("changeMarks.nearLps"),
            Clause::saying("goes with clear and accept"));
    return changeSurface(document, false);
}

EditEffects effects(const ChangeMarks&)
{
    return surfaceEffects(false);
}

RowTitle rowTitle(const ChangeMarks& change, const RowFacts& row)
{
    return {.code = titleCode(change),
        .arguments = {asArgument(markTitle(change.mark))},
        .then = {figure(RowTitleCode::Vertices, row.statistics.verticesChanged)}};
}

EditDependencies dependencies(const ChangeMarks&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

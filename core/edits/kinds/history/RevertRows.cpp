// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/RevertRows.h"

#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/answers/RowUse.h"

namespace core {

using namespace rowWords;

/// It reads the history, not the document.
Result<void> check(const RevertRows&, const Document&)
{
    return {};
}

Result<bool> apply(const RevertRows&, Document&)
{
    return false;
}

EditEffects effects(const RevertRows&)
{
    return {.task = EditTask::History,
        .standsOpen = false,
        .fills = fillsNothing,
        .boundToStudy = true};
}

RowTitle rowTitle(const RevertRows& edit, const RowFacts& row)
{
    RowTitle title = edit.rows.size() == 1
        ? RowTitle{.code = RowTitleCode::UndoOnly,
            .arguments = {asArgument(row.past.headlineOf(edit.rows.front()))}}
        : figure(RowTitleCode::UndoOnlySteps, std::int64_t(edit.rows.size()));
    const std::int64_t voxels = row.statistics.voxelsChanged;
    title.then = {voxels > 0 ? figure(RowTitleCode::Voxels, voxels)
                             : figure(RowTitleCode::SeedVoxels, row.facts.seedWordsChanged)};
    return title;
}

/// The bricks of the rows that it took back.
EditDependencies dependencies(const RevertRows&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

RowUse rowUse(const RevertRows&)
{
    return RowUse::TakesBack;
}

} // namespace core

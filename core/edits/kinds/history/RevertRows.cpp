// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/RevertRows.h"

#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/RowFacts.h"

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
    return {.task = EditTask::History, .standsOpen = false, .boundToStudy = true};
}

QString rowName(const RevertRows& edit, const RowFacts& row)
{
    const QString what = edit.rows.size() == 1
        ? QLatin1Char('\'') + row.past.titleOf(edit.rows.front()) + QLatin1Char('\'')
        : counted(std::int64_t(edit.rows.size()), "step");
    const std::int64_t voxels = row.statistics.voxelsChanged;
    return QStringLiteral("Undo only ") + what + QStringLiteral(", ")
        + (voxels > 0 ? counted(voxels, "voxel")
                      : counted(row.facts.seedWordsChanged, "seed voxel"));
}

/// The bricks of the rows that it took back.
EditReach reach(const RevertRows&, const ReachFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/AuditReport.h"

#include "core/edits/EditNames.h"
#include "core/sessionfile/records/SessionTables.h"

#include <QFileInfo>

#include <utility>

namespace core {

namespace {

/// Which later step that stands undid a row alone or revised it, by row; 0: none.
struct LaterSteps {
    explicit LaterSteps(const History& history)
        : takenBackBy(history.rows().size() + 1, 0)
        , revisedBy(history.rows().size() + 1, 0)
    {
        for (const RowId id : history.standing()) {
            const NamedRows named = rowsNamedBy(history.row(id).edit);
            for (const RowId row : named.rows) {
                switch (named.use) {
                case RowUse::TakesBack:
                    takenBackBy[std::size_t(row)] = id;
                    break;
                case RowUse::Revises:
                    revisedBy[std::size_t(row)] = id;
                    break;
                case RowUse::None:
                    break;
                }
            }
        }
    }

    std::vector<RowId> takenBackBy;
    std::vector<RowId> revisedBy;
};

std::vector<AuditStep> stepsOf(const History& history)
{
    std::vector<AuditStep> steps;
    const LaterSteps later(history);
    for (const HistoryRow& row : history.rows())
        steps.push_back({.row = row,
            .standing = AuditStep::Standing::OtherBranch,
            .takenBackBy = later.takenBackBy[std::size_t(row.id)],
            .revisedBy = later.revisedBy[std::size_t(row.id)]});
    for (const RowId id : history.line())
        steps[std::size_t(id - 1)].standing = AuditStep::Standing::Undone;
    for (const RowId id : history.pathTo(history.position())) {
        AuditStep& step = steps[std::size_t(id - 1)];
        step.standing =
            step.takenBackBy == 0 ? AuditStep::Standing::Done : AuditStep::Standing::TakenBack;
    }
    return steps;
}

} // namespace

Result<AuditReport> auditReport(SessionTables& tables, const QString& path)
{
    Result<SessionContents> contents = tables.readAgain();
    if (!contents)
        return tl::unexpected(contents.error());
    const History history =
        History::restored(contents->rows, contents->visited, contents->position);
    AuditReport report{.file = QFileInfo(path).fileName(),
        .source = std::move(contents->source),
        .steps = stepsOf(history),
        .branches = branchesOf(history),
        .position = contents->position,
        .keyframes = std::move(contents->keyframes),
        .chainEnd = contents->chainEnd,
        .made = presentOrigin()};
    if (contents->damage)
        report.damage.push_back(contents->damage->error(path));
    for (const HistoryRow& row : history.rows()) {
        if (row.stateHash.isEmpty())
            continue;
        if (const Result<BrickDelta> delta = tables.readDelta(row.id); delta)
            ++report.sealed;
        else
            report.damage.push_back(delta.error());
    }
    if (report.damage.empty() && !contents->cutOff.isEmpty())
        report.damage.push_back({ErrorCode::SessionDamaged, {path, contents->cutOff}});
    for (Keyframe& keyframe : report.keyframes)
        keyframe.png = tables.readKeyframe(keyframe.row);
    return report;
}

} // namespace core

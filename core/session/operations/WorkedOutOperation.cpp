// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/WorkedOutOperation.h"

#include "core/edits/document/DocumentEdits.h"

#include <algorithm>
#include <utility>

namespace core {

WorkedOutOperation::Watch::Watch()
    : progress([this](ProgressStep, int done, int total) {
        constexpr std::int64_t percents = 100;
        percent = int(percents * done / std::max(1, total));
    })
{
}

WorkedOutOperation::WorkedOutOperation(RowId again)
    : m_watch(std::make_shared<Watch>())
    , m_relabelling(again)
{
}

bool WorkedOutOperation::mayStart(SessionState& state, const Edit& edit)
{
    const Result<void> checked = checkAgainst(state.document, edit);
    if (!checked)
        giveUp(state, checked.error());
    return checked.has_value();
}

bool WorkedOutOperation::mayGoOn(SessionState& state)
{
    const bool isAborted = m_watch->progress.cancelled();
    if (isAborted)
        giveUp(state, {ErrorCode::Cancelled, {}});
    return !isAborted;
}

void WorkedOutOperation::workAside(SessionState& state, SideThread::Work work)
{
    state.side->post(
        std::move(work), [this](SessionState& known, const Error& error) { giveUp(known, error); });
}

void WorkedOutOperation::write(SessionState& state, const Edit& edit, Result<Listed>&& listed)
{
    if (!listed)
        return giveUp(state, listed.error());
    if (!mayGoOn(state))
        return;
    m_isWriting = true;
    std::visit([&](auto& known) { m_relabelling.write(state, edit, std::move(known)); }, *listed);
}

void WorkedOutOperation::takeWritten(SessionState& state, EngineResult&& result)
{
    m_relabelling.takeResult(state, std::move(result));
}

void WorkedOutOperation::abort()
{
    if (isAbortable())
        m_watch->progress.cancel();
}

} // namespace core

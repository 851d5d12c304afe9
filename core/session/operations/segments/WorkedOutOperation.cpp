// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/WorkedOutOperation.h"

#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"

#include <utility>

namespace core {

WorkedOutOperation::WorkedOutOperation(Edit edit, Kind kind, RowId again)
    : m_edit(std::move(edit))
    , m_manner(openMannerOf(m_edit))
    , m_ending(kind == Kind::Whole ? std::optional(Ending::Commit) : std::nullopt)
    , m_watch(std::make_shared<Watch>())
    , m_relabelling(again)
{
}

bool WorkedOutOperation::mayStart(SessionState& state)
{
    if (!mayGoOn(state))
        return false;
    const Result<void> checked = checkAgainst(state.document, m_edit);
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
    m_aside.post(*state.side, std::move(work),
        [this](SessionState& known, const Error& error) { giveUp(known, error); });
}

void WorkedOutOperation::write(SessionState& state, Result<Listed>&& listed)
{
    if (!listed)
        return giveUp(state, listed.error());
    if (!mayGoOn(state))
        return;
    m_isWriting = true;
    std::visit([&](auto& known) { m_relabelling.begin(state, m_edit, std::move(known)); }, *listed);
    if (m_ending)
        m_relabelling.end(state, *m_ending);
}

void WorkedOutOperation::leaveAsItIs(SessionState& state)
{
    m_isWriting = true;
    if (m_ending)
        m_relabelling.end(state, *m_ending);
}

/// Nobody waits for what was rolled back, nor hears why it has failed.
void WorkedOutOperation::giveUp(SessionState& state, const Error& error)
{
    if (isRolledBack())
        m_relabelling.leaveNoRow(state);
    else
        m_relabelling.giveUp(state, error);
}

void WorkedOutOperation::takeWritten(SessionState& state, EngineResult&& result)
{
    m_relabelling.takeResult(state, std::move(result));
}

bool WorkedOutOperation::isAbortable() const
{
    return !m_isWriting && !done() && !isRolledBack();
}

void WorkedOutOperation::abort(SessionState&)
{
    if (isAbortable())
        m_watch->progress.cancel();
}

void WorkedOutOperation::end(SessionState& state, Ending ending)
{
    if (!open())
        return;
    m_ending = ending;
    if (m_isWriting)
        m_relabelling.end(state, ending);
    else if (isRolledBack())
        m_watch->progress.cancel();
}

bool WorkedOutOperation::abandon(SessionState& state, const Error& error)
{
    if (done() || m_relabelling.isAgain())
        return false;
    m_ending = Ending::Rollback;
    if (m_isWriting)
        return m_relabelling.abandon(state, error);
    state.fail(error);
    m_watch->progress.cancel();
    m_aside.giveUp([this] { m_relabelling.drop(); });
    return true;
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/Relabelling.h"

#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

Relabelling::Relabelling(RowId again)
    : m_again(again)
{
}

template <class Listed> void Relabelling::submit(SessionState& state, Edit&& edit, Listed&& listed)
{
    if (listed.bricks.empty())
        return;
    m_edit = std::move(edit);
    m_begun = state.engine.submit(BeginEdit{std::forward<Listed>(listed)});
}

void Relabelling::begin(SessionState& state, Edit edit, RelabelListed&& relabel)
{
    submit(state, std::move(edit), std::move(relabel));
}

void Relabelling::begin(SessionState& state, Edit edit, LabelListed&& label)
{
    submit(state, std::move(edit), std::move(label));
}

void Relabelling::begin(SessionState& state, Edit edit, LabelPlanes&& planes)
{
    m_edit = std::move(edit);
    m_begun = state.engine.submit(BeginEdit{std::move(planes)});
}

void Relabelling::begin(SessionState& state, Edit edit, const MapLabels& map)
{
    m_edit = std::move(edit);
    m_begun = state.engine.submit(BeginEdit{map});
}

void Relabelling::end(SessionState& state, Ending ending)
{
    if (m_done || m_ended)
        return;
    if (!m_begun)
        return leaveNoRow(state);
    m_ended = state.engine.submit(EndEdit{ending});
}

void Relabelling::write(SessionState& state, Edit edit, RelabelListed&& relabel)
{
    begin(state, std::move(edit), std::move(relabel));
    end(state, Ending::Commit);
}

void Relabelling::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_begun && result.ticket == *m_begun) {
        // The edit was refused; the result of an EndEdit that is under way will fail again.
        m_failed = true;
        m_done = !m_ended;
        state.fail(*result.error);
    } else if (m_ended && result.ticket == *m_ended)
        finish(state, std::move(result));
}

void Relabelling::finish(SessionState& state, EngineResult&& result)
{
    if (result.error) {
        m_done = true;
        if (!m_failed)
            state.fail(*result.error);
        return;
    }
    if (m_failed)
        return drop();
    if (result.changes.empty())
        return leaveNoRow(state);
    m_done = true;
    if (m_again != 0)
        state.complete(m_again, std::move(result));
    else
        state.commit(m_edit, std::move(result), {});
}

void Relabelling::leaveNoRow(SessionState& state)
{
    m_done = true;
    if (m_again != 0)
        state.fail({ErrorCode::SessionDamaged,
            {state.file ? state.file->path() : QString(),
                Clause::saying("row %1 changes nothing when it is carried out again", m_again)}});
}

void Relabelling::giveUp(SessionState& state, const Error& error)
{
    state.fail(error);
    drop();
}

bool Relabelling::abandon(SessionState& state, const Error& error)
{
    if (m_done || m_ended || isAgain())
        return false;
    state.fail(error);
    if (!m_begun) {
        drop();
        return true;
    }
    m_failed = true;
    m_ended = state.engine.submit(EndEdit{Ending::Rollback});
    return true;
}

} // namespace core

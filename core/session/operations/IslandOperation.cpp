// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/IslandOperation.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

IslandOperation::IslandOperation(const CleanSegment& edit, RowId again)
    : m_edit(edit)
    , m_again(again)
{
}

void IslandOperation::start(SessionState& state)
{
    // What waited in line may meet another document than the one it was checked against.
    if (const Result<void> checked = checkAgainst(state.document, m_edit); !checked)
        return giveUp(state, checked.error());
    m_reader.emplace(state.document.volumes.front().geometry.size,
        state.document.segment(m_edit.segment)->plane);
    readNext(state);
}

void IslandOperation::readNext(SessionState& state)
{
    if (std::optional<ReadBricks> question = m_reader->next()) {
        m_asked = state.engine.submit(*std::move(question));
        return;
    }
    state.side->post(
        [this, edit = m_edit, document = state.document,
            reader = std::make_shared<LabelReader>(*std::move(m_reader))] {
            auto relabel = std::make_shared<Result<RelabelListed>>(
                relabelListed(edit, document, reader->takeLabels()));
            return SideThread::Sequel(
                [this, relabel](SessionState& known) { write(known, std::move(*relabel)); });
        },
        [this](SessionState& known, const Error& error) { giveUp(known, error); });
    m_reader.reset();
}

void IslandOperation::write(SessionState& state, Result<RelabelListed>&& relabel)
{
    if (!relabel)
        return giveUp(state, relabel.error());
    if (relabel->bricks.empty())
        return leaveNoRow(state);
    m_begun = state.engine.submit(BeginEdit{*std::move(relabel)});
    m_ended = state.engine.submit(EndEdit{});
}

void IslandOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_asked && result.ticket == *m_asked) {
        m_asked.reset();
        if (const Result<void> taken = m_reader->take(result); !taken)
            return giveUp(state, taken.error());
        return readNext(state);
    }
    if (m_begun && result.ticket == *m_begun) { // it never opened, and its end tells so again
        m_failed = true;
        state.fail(*result.error);
    } else if (m_ended && result.ticket == *m_ended)
        finish(state, std::move(result));
}

void IslandOperation::finish(SessionState& state, EngineResult&& result)
{
    if (result.error) {
        m_done = true;
        if (!m_failed)
            state.fail(*result.error);
        return;
    }
    if (result.changes.empty())
        return leaveNoRow(state);
    m_done = true;
    if (m_again != 0)
        state.complete(m_again, std::move(result));
    else
        state.commit(m_edit, std::move(result), {});
}

void IslandOperation::leaveNoRow(SessionState& state)
{
    m_done = true;
    if (m_again != 0)
        state.fail({ErrorCode::SessionDamaged,
            {state.file ? state.file->path() : QString(),
                QStringLiteral("row %1 changes nothing when it is carried out again")
                    .arg(m_again)}});
}

void IslandOperation::giveUp(SessionState& state, const Error& error)
{
    state.fail(error);
    m_done = true;
}

} // namespace core

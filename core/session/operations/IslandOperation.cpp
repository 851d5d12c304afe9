// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/IslandOperation.h"

#include "core/edits/document/DocumentEdits.h"

#include <utility>

namespace core {

IslandOperation::IslandOperation(const CleanSegment& edit, RowId again)
    : m_edit(edit)
    , m_relabelling(again)
{
}

void IslandOperation::start(SessionState& state)
{
    // What waited in line may meet another document than the one it was checked against.
    if (const Result<void> checked = checkAgainst(state.document, m_edit); !checked)
        return m_relabelling.giveUp(state, checked.error());
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
        [this](SessionState& known, const Error& error) { m_relabelling.giveUp(known, error); });
    m_reader.reset();
}

void IslandOperation::write(SessionState& state, Result<RelabelListed>&& relabel)
{
    if (!relabel)
        return m_relabelling.giveUp(state, relabel.error());
    m_relabelling.write(state, m_edit, *std::move(relabel));
}

void IslandOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_asked && result.ticket == *m_asked) {
        m_asked.reset();
        if (const Result<void> taken = m_reader->take(result); !taken)
            return m_relabelling.giveUp(state, taken.error());
        return readNext(state);
    }
    m_relabelling.takeResult(state, std::move(result));
}

} // namespace core

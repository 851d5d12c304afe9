// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/ChunkOperation.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

DivideOperation::DivideOperation(DivideSegment edit, RowId again)
    : m_edit(std::move(edit))
    , m_again(again)
{
}

bool DivideOperation::foresee(Document& document) const
{
    return bool(applyToDocument(m_edit, document));
}

void DivideOperation::start(SessionState& state)
{
    if (m_again != 0) {
        m_done = true;
        return state.complete(m_again, {});
    }
    // What waited in line may meet another document than the one it was checked against.
    if (const Result<void> checked = checkAgainst(state.document, m_edit); !checked)
        return giveUp(state, checked.error());
    if (m_edit.owners)
        return commit(state);
    m_reading.emplace(state.document.volumes.front().geometry.size,
        state.document.segment(m_edit.segment)->plane);
    readNext(state);
}

void DivideOperation::readNext(SessionState& state)
{
    if (m_reading->ask(state.engine))
        return;
    m_aside.post(
        *state.side,
        [this, edit = m_edit, geometry = state.document.volumes.front().geometry,
            reader = std::make_shared<LabelReader>(std::move(m_reading->reader()))] {
            const Result<std::vector<std::uint8_t>> map = probabilitiesOf(edit, geometry);
            auto owners = std::make_shared<Result<std::vector<ChunkOwner>>>(map
                    ? chunkOwners(edit, geometry, reader->takeLabels())
                    : tl::unexpected(map.error()));
            return SideThread::Sequel(
                [this, owners](SessionState& known) { takeOwners(known, std::move(*owners)); });
        },
        [this](SessionState& known, const Error& error) { giveUp(known, error); });
    m_reading.reset();
}

void DivideOperation::takeOwners(SessionState& state, Result<std::vector<ChunkOwner>>&& owners)
{
    if (!owners)
        return giveUp(state, owners.error());
    m_edit.owners = *std::move(owners);
    commit(state);
}

void DivideOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (!m_reading || !m_reading->awaits(result.ticket))
        return;
    if (const Result<void> taken = m_reading->take(result); !taken)
        return giveUp(state, taken.error());
    readNext(state);
}

void DivideOperation::commit(SessionState& state)
{
    m_done = true;
    const RowId newest = state.divisionRow();
    if (newest == 0 || !(state.history.row(newest).edit.get<DivideSegment>() == m_edit))
        state.commit(m_edit, {}, {});
}

bool DivideOperation::abandon(SessionState& state, const Error& error)
{
    if (m_done || m_again != 0)
        return false;
    state.fail(error);
    m_aside.giveUp([this] { m_done = true; });
    return true;
}

void DivideOperation::giveUp(SessionState& state, const Error& error)
{
    state.fail(error);
    m_done = true;
}

ToggleChunks::ToggleChunks(ChunkToggle edit, RowId again)
    : m_edit(std::move(edit))
    , m_relabelling(again)
{
}

void ToggleChunks::start(SessionState& state)
{
    Result<ChunkClick> click = chunkClick(m_edit, state.document);
    if (!click)
        return m_relabelling.giveUp(state, click.error());
    m_click = *std::move(click);
    m_awaited = state.divisionRow();
    state.chunks->forgetFailure();
    state.wantChunks();
    takeChunks(state);
}

void ToggleChunks::takeChunks(SessionState& state)
{
    if (!m_awaited)
        return;
    if (const std::optional<Error> why = state.chunks->whyNot(*m_awaited)) {
        static_cast<void>(state.chunks->takeUnreported()); // it is told here
        return m_relabelling.giveUp(state, *why);
    }
    if (const ChunkWorker::Map map = state.chunks->map(*m_awaited)) {
        m_awaited.reset();
        click(state, *map);
    }
}

void ToggleChunks::click(SessionState& state, const ChunkMap& map)
{
    m_clicked.emplace(map, m_edit, m_click);
    if (m_clicked->empty())
        return m_relabelling.leaveNoRow(state);
    const std::vector<std::uint32_t> bricks = m_clicked->bricks();
    m_edit.bricks.emplace(bricks.begin(), bricks.end());
    if (m_edit.mode != ChunkToggle::Mode::Toggle)
        return relabel(state, {});
    ReadBricks read;
    for (const std::uint32_t brick : bricks)
        read.keys.push_back({Field::Labels, m_click.target.plane, brick});
    m_asked = state.engine.submit(std::move(read));
}

/// Which of the chunks are the segment's already is counted beside.
void ToggleChunks::relabel(SessionState& state, std::vector<BrickChange> labels)
{
    m_aside.post(
        *state.side,
        [this, clicked = std::make_shared<const ClickedChunks>(*std::move(m_clicked)),
            labels = std::move(labels)] {
            auto relabelled = std::make_shared<RelabelListed>(clicked->relabelled(labels));
            return SideThread::Sequel([this, relabelled](SessionState& known) {
                m_relabelling.write(known, m_edit, std::move(*relabelled));
            });
        },
        [this](SessionState& known, const Error& error) { m_relabelling.giveUp(known, error); });
    m_clicked.reset();
}

bool ToggleChunks::abandon(SessionState& state, const Error& error)
{
    m_awaited.reset();
    if (!m_aside.isAway() || m_relabelling.isAgain())
        return m_relabelling.abandon(state, error);
    state.fail(error);
    m_aside.giveUp([this] { m_relabelling.drop(); });
    return true;
}

void ToggleChunks::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_asked && result.ticket == *m_asked) {
        m_asked.reset();
        return result.error ? m_relabelling.giveUp(state, *result.error)
                            : relabel(state, std::move(result.changes));
    }
    m_relabelling.takeResult(state, std::move(result));
}

} // namespace core

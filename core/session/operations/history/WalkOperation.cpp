// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/history/WalkOperation.h"

#include "core/engine/EngineCommands.h"

#include <algorithm>
#include <utility>

namespace core {

WalkOperation::WalkOperation(Aim aim, RowId target)
    : m_aim(aim)
    , m_target(target)
{
}

void WalkOperation::start(SessionState& state)
{
    step(state);
}

bool WalkOperation::choose(const History& history)
{
    const RowId position = history.position();
    if (m_aim == Aim::Undo) {
        m_back = true;
        m_row = position;
        return m_row != 0;
    }
    if (m_aim == Aim::Redo) {
        m_back = false;
        m_row = history.redoTarget();
        return m_row != 0;
    }
    if (position == m_target)
        return false;
    const std::vector<RowId> path = history.pathTo(m_target);
    const auto here = std::find(path.begin(), path.end(), position);
    m_back = position != 0 && here == path.end();
    m_row = m_back ? position : (position == 0 ? path.front() : *std::next(here));
    return true;
}

void WalkOperation::step(SessionState& state)
{
    if (!choose(state.history)) {
        m_done = true;
        return;
    }
    std::optional<std::vector<BrickImage>> images = state.recent.images(m_row, !m_back);
    if (!images) {
        state.worker->load(m_row);
        m_isLoading = true;
        return;
    }
    if (images->empty())
        arrive(state, {});
    else
        put(state, SwapBricks{.bricks = *std::move(images)});
}

void WalkOperation::takeDifferences(SessionState& state, Result<RowDifferences>&& differences)
{
    m_isLoading = false;
    if (m_isAbandoned)
        m_done = true; // it has only read
    else if (!differences)
        giveUp(state, differences.error());
    else if (differences->images.empty())
        arrive(state, {});
    else
        put(state, XorBricks{.differences = std::move(differences->images)});
}

void WalkOperation::put(SessionState& state, EngineCommand command)
{
    m_swapping = state.engine.submit(std::move(command));
}

void WalkOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (!m_swapping || result.ticket != *m_swapping)
        return;
    m_swapping.reset();
    if (result.error)
        giveUp(state, *result.error);
    else
        arrive(state, std::move(result));
}

bool WalkOperation::foreseePosition(const History& history, ForeseenPosition& position) const
{
    if (m_done)
        return true;
    if (m_aim == Aim::Undo) {
        position.row = position.row == 0 ? 0 : history.row(position.row).parent;
        return true;
    }
    const auto visited = position.visited.find(position.row);
    const RowId child = visited == position.visited.end() ? history.childLastVisited(position.row)
                                                          : visited->second;
    const RowId target = m_aim == Aim::Row ? m_target : child;
    if (target == 0) {
        position.row = m_aim == Aim::Row ? 0 : position.row;
        return true;
    }
    for (const RowId row : history.pathTo(target))
        position.visited[history.row(row).parent] = row;
    position.row = target;
    return true;
}

bool WalkOperation::abandon(SessionState& state, const Error& error)
{
    if (m_arriving || m_swapping)
        return false;
    if (m_isLoading) {
        // Whoever comes next would take what is on its way for the difference of its own row.
        state.fail(error);
        m_isAbandoned = true;
    } else {
        giveUp(state, error);
    }
    return true;
}

void WalkOperation::arrive(SessionState& state, EngineResult&& result)
{
    m_arriving = true;
    state.moveTo(m_back ? state.history.row(m_row).parent : m_row, m_row, std::move(result));
    m_arriving = false;
    if (m_aim == Aim::Row)
        step(state);
    else
        m_done = true;
}

void WalkOperation::giveUp(SessionState& state, const Error& error)
{
    state.fail(error);
    m_done = true;
}

} // namespace core

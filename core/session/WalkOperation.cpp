// SPDX-License-Identifier: Apache-2.0
#include "core/session/WalkOperation.h"

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
    if (const Changes changes = state.recent(m_row)) {
        std::vector<BrickImage> images;
        images.reserve(changes->size());
        for (const BrickChange& change : *changes)
            images.push_back({change.key, m_back ? change.before : change.after});
        swap(state, std::move(images));
    } else {
        state.worker->load(m_row);
    }
}

void WalkOperation::takeDifferences(
    SessionState& state, Result<std::vector<BrickImage>>&& differences)
{
    if (!differences)
        return giveUp(state, differences.error());
    m_differences = *std::move(differences);
    if (m_differences.empty())
        return arrive(state, {});
    ReadBricks read;
    for (const BrickImage& difference : m_differences)
        read.keys.push_back(difference.key);
    m_reading = state.engine.submit(std::move(read));
}

void WalkOperation::swap(SessionState& state, std::vector<BrickImage> images)
{
    if (images.empty())
        return arrive(state, {});
    m_swapping = state.engine.submit(SwapBricks{std::move(images)});
}

void WalkOperation::takeResult(SessionState& state, EngineResult&& result)
{
    const bool read = m_reading && result.ticket == *m_reading;
    const bool swapped = m_swapping && result.ticket == *m_swapping;
    if (!read && !swapped)
        return;
    if (result.error)
        return giveUp(state, *result.error);
    if (swapped)
        return arrive(state, std::move(result.changes));
    m_reading.reset();
    std::vector<BrickImage> images;
    images.reserve(result.changes.size());
    for (std::size_t i = 0; i < result.changes.size(); ++i) {
        BrickChange& now = result.changes[i];
        images.push_back(exclusiveOr({now.key, std::move(now.after)}, m_differences[i]));
    }
    m_differences.clear();
    swap(state, std::move(images));
}

void WalkOperation::arrive(SessionState& state, std::vector<BrickChange> changes)
{
    m_swapping.reset();
    state.moveTo(m_back ? state.history.row(m_row).parent : m_row, std::move(changes));
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

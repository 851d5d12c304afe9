// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionKeyframes.h"

#include "core/session/state/SessionState.h"

#include <utility>

namespace core {

SessionKeyframes::SessionKeyframes(SessionState& state)
    : m_state(state)
{
}

std::vector<RowId> SessionKeyframes::rows() const
{
    return {m_state.keyframes.begin(), m_state.keyframes.end()};
}

void SessionKeyframes::add(RowId row, const QByteArray& png)
{
    if (!m_state.file)
        return;
    m_state.keyframes.insert(row);
    m_state.file->addKeyframe({.row = row, .at = m_state.origin().at, .png = png});
}

void SessionKeyframes::fetch(RowId row, std::function<void(const QByteArray& png)> take) const
{
    if (m_state.file)
        m_state.file->fetchKeyframe(row, std::move(take));
    else
        take({});
}

} // namespace core

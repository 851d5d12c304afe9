// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionChunks.h"

#include "core/session/state/SessionState.h"

namespace core {

SessionChunks::SessionChunks(SessionState& state)
    : m_state(state)
{
}

std::shared_ptr<const ChunkMap> SessionChunks::map()
{
    m_state.wantChunks();
    return m_state.chunks->map(m_state.divisionRow());
}

std::shared_ptr<const CoarseChunks> SessionChunks::coarse() const
{
    return m_state.chunks->coarse(m_state.divisionRow());
}

std::optional<ChunkStage> SessionChunks::stage() const
{
    return m_state.chunks->stage();
}

std::optional<Error> SessionChunks::whyNot() const
{
    return m_state.chunks->lastFailure();
}

void SessionChunks::forgetFailure()
{
    m_state.chunks->forgetFailure();
}

void SessionChunks::cancel()
{
    m_state.chunks->cancel();
}

} // namespace core

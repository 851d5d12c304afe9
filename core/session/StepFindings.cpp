// SPDX-License-Identifier: Apache-2.0
#include "core/session/StepFindings.h"

#include "core/session/state/SessionState.h"

namespace core {

StepFindings::StepFindings(const SessionState& state)
    : m_state(state)
{
}

std::vector<RowId> StepFindings::strokesOnRevisedSurface() const
{
    const SessionState::Revision& revision = m_state.lastRevision;
    return revision.row == m_state.history.position() ? revision.begunInside : std::vector<RowId>();
}

std::optional<LeakAlarm> StepFindings::leakAlarm() const
{
    const std::optional<SessionState::Alarm>& alarm = m_state.lastAlarm;
    return alarm && alarm->row == m_state.history.position() ? std::optional(alarm->found)
                                                             : std::nullopt;
}

const std::optional<SketchedSeeds>& StepFindings::sketchedSeeds() const
{
    return m_state.lastSketched;
}

} // namespace core

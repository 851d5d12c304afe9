// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/GrowthPast.h"

#include "core/session/EditSession.h"
#include "core/session/past/RecentGrowth.h"
#include "ui/settings/SeedValues.h"

namespace ui {

const GrowthPast::Known& GrowthPast::of(const core::EditSession& session)
{
    const core::History& history = session.history();
    if (m_position == history.position())
        return m_known;
    m_known = {.seeds = sketchedSeeds(session),
        .criteria = core::recentCriteria(history),
        .growing = core::growingSegments(history, session.document())};
    m_position = history.position();
    return m_known;
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/growth/GrowthPast.h"

#include "core/session/EditSession.h"
#include "core/session/past/RecentGrowth.h"
#include "ui/settings/growth/SeedValues.h"

namespace ui {

const GrowthPast::Known& GrowthPast::of(const core::EditSession& session, std::uint8_t plane)
{
    const core::History& history = session.history();
    const std::pair asked(history.position(), plane);
    if (m_asked == asked)
        return m_known;
    m_known = {.seeds = sketchedSeeds(session, plane),
        .criteria = core::recentCriteria(history, plane),
        .growing = core::growingSegments(history, session.document(), plane),
        .grown = core::grownIn(history, plane),
        .barriers = core::lastBarrierRow(history)};
    m_asked = asked;
    return m_known;
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/growth/AcceptedFronts.h"

#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/session/EditSession.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Measured on skulls: by the fields alone 4 to 11 alarms, and up to 28; with twice the area 1 to 3
/// of them are left, with four times 1 to 3 too. Leaks are the later seen the more it is.
constexpr double times = 2.0;
constexpr double um2PerMm2 = 1.0e6;
constexpr double mostAreaMm2 = 1.0e6; ///< that an edit can have

} // namespace

void AcceptedFronts::accept(const core::LeakAlarm& alarm, std::uint8_t plane,
    const std::vector<int>& labels, const core::EditSession& session)
{
    if (alarm.areaUm2 == 0)
        return;
    const double areaMm2 = std::ceil(times * double(alarm.areaUm2) / um2PerMm2);
    // What has grown until the alarm may be on its way to its row.
    const core::History& history = session.history();
    const std::size_t rows = history.rows().size() + (session.idle() ? 0 : 1);
    const core::RowId row = session.idle() ? history.position() : core::RowId(rows);
    for (const int label : labels)
        m_fronts.push_back({.label = label,
            .plane = plane,
            .generation = alarm.generation,
            .areaMm2 = std::min(areaMm2, mostAreaMm2),
            .row = row,
            .rows = rows});
}

void AcceptedFronts::forget(const std::vector<int>& labels)
{
    std::erase_if(m_fronts, [&labels](const Front& front) {
        return std::find(labels.begin(), labels.end(), front.label) != labels.end();
    });
}

double AcceptedFronts::areaMm2(const std::vector<int>& labels) const
{
    double least = labels.empty() ? 0.0 : mostAreaMm2;
    for (const int label : labels) {
        double widest = 0.0;
        for (const Front& front : m_fronts) {
            if (front.label == label)
                widest = std::max(widest, front.areaMm2);
        }
        least = std::min(least, widest);
    }
    return least;
}

void AcceptedFronts::follow(const GrowSettings& settings)
{
    const std::pair guard(settings.guard, settings.guardAreaMm2);
    if (std::exchange(m_guard, guard) != guard)
        clear();
}

void AcceptedFronts::follow(const core::EditSession& session)
{
    if (m_fronts.empty())
        return;
    const std::vector<core::RowId> standing = session.history().standing();
    std::erase_if(m_fronts, [&](const Front& front) { return !holds(front, standing, session); });
}

bool AcceptedFronts::holds(
    const Front& front, const std::vector<core::RowId>& standing, const core::EditSession& session)
{
    const core::History& history = session.history();
    if (!session.document().segment(front.label))
        return false;
    // The growth that raised the alarm, or the one that goes on, is no row yet.
    const std::size_t rows = history.rows().size();
    if (rows < front.rows || (rows == front.rows && history.position() == front.row))
        return true;
    const auto accepted = std::find(standing.begin(), standing.end(), front.row);
    if (accepted == standing.end()
        || session.document().generation(front.plane) <= front.generation)
        return false;
    return std::none_of(accepted + 1, standing.end(), [&](core::RowId id) {
        const core::Edit& edit = history.row(id).edit;
        const auto* seeds = edit.as<core::SeedStroke>();
        const auto* cut = edit.as<core::ShrinkAt>();
        return (seeds && seeds->segment == front.label && !seeds->pointsLps.empty())
            || (cut && core::growthPlaneOf(cut->plane) == front.plane);
    });
}

} // namespace ui

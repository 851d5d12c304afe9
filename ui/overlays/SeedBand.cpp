// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/SeedBand.h"

#include "core/session/past/SeedStrokes.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Ascending, those that overlap or touch as one.
std::vector<core::CodeInterval> united(std::vector<core::CodeInterval> intervals)
{
    std::sort(intervals.begin(), intervals.end(),
        [](const core::CodeInterval& a, const core::CodeInterval& b) { return a.low < b.low; });
    std::vector<core::CodeInterval> apart;
    for (const core::CodeInterval& next : intervals) {
        if (next.low > next.high)
            continue;
        if (!apart.empty() && next.low <= apart.back().high + 1)
            apart.back().high = std::max(apart.back().high, next.high);
        else
            apart.push_back(next);
    }
    return apart;
}

} // namespace

SeedBand::SeedBand(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_waiting = false; // the old session answers no more
        set({});
        ask();
    });
    connect(&workspace, &Workspace::growSettingsChanged, this, &SeedBand::ask);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &SeedBand::ask);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::History)
                ask();
        });
}

void SeedBand::set(const std::optional<SeedStretches>& stretches)
{
    if (stretches == m_stretches)
        return;
    m_stretches = stretches;
    Q_EMIT changed();
}

void SeedBand::ask()
{
    core::EditSession* session = m_workspace.session();
    const core::Volume* volume = m_workspace.volume();
    const GrowSettings& settings = m_workspace.growSettings();
    if (!session || !volume || !settings.sigmas.on) {
        set({});
        return;
    }
    m_stale = m_waiting;
    if (m_waiting)
        return;
    m_waiting = true;
    const core::CodeInterval interval{.low = volume->encoding.lowestCodeAtLeast(settings.lower),
        .high = volume->encoding.highestCodeAtMost(settings.upper)};
    const std::uint8_t plane = m_workspace.growthPlane();
    session->questions().seedSums(plane, interval,
        core::seedStrokes(session->history(), session->document(), plane),
        [band = QPointer<SeedBand>(this), session, interval](
            const core::Result<std::vector<core::ProbedSeeds>>& seeds) {
            if (!band || band->m_workspace.session() != session)
                return;
            band->m_waiting = false;
            if (band->m_stale) {
                band->ask();
                return;
            }
            band->set(seeds ? band->stretchesOf(*seeds, interval) : std::nullopt);
        });
}

std::optional<SeedStretches> SeedBand::stretchesOf(
    const std::vector<core::ProbedSeeds>& probed, const core::CodeInterval& interval) const
{
    const GrowSettings& settings = m_workspace.growSettings();
    if (!settings.sigmas.on)
        return std::nullopt;
    SeedStretches stretches;
    std::vector<core::CodeInterval> intervals;
    std::optional<core::CodeInterval> newest;
    for (const core::ProbedSeeds& seeds : probed) {
        if (int(seeds.label) != m_workspace.activeSegment())
            continue;
        core::CodeInterval codes =
            core::seedInterval(seeds.sums, int(std::lround(settings.sigmas.value * 256.0)));
        codes.low = std::max(codes.low, interval.low);
        codes.high = std::min(codes.high, interval.high);
        intervals.push_back(codes);
        if (seeds.group) {
            ++stretches.strokes;
            newest = codes; // strokes stand in their order
        } else {
            stretches.others = true;
        }
    }
    if (intervals.empty())
        return std::nullopt;
    const auto valuesOf = [this](const core::CodeInterval& codes) {
        const core::VoxelEncoding& encoding = m_workspace.volume()->encoding;
        return SeedStretches::Stretch(encoding.value(codes.low), encoding.value(codes.high));
    };
    if (newest && newest->low <= newest->high && intervals.size() > 1)
        stretches.newest = valuesOf(*newest);
    for (const core::CodeInterval& codes : united(std::move(intervals)))
        stretches.values.push_back(valuesOf(codes));
    return stretches;
}

} // namespace ui

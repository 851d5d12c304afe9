// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/GrowthRun.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/session/EditSession.h"
#include "core/session/past/RecentGrowth.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <utility>

namespace ui {

namespace {

constexpr int runMilliseconds = 40;

} // namespace

GrowthRun::GrowthRun(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_watch.setInterval(runMilliseconds);
    connect(&m_watch, &QTimer::timeout, this, &GrowthRun::poll);
}

void GrowthRun::begin(std::vector<GrowthTurn> turns, double generationsPerSecond)
{
    dropTurns();
    m_nextTurn = false;
    if (turns.empty() || !beginBurst(growthOf(turns.front(), m_workspace), generationsPerSecond))
        return;
    m_turns = std::move(turns);
    m_pace = generationsPerSecond;
}

void GrowthRun::resume()
{
    dropTurns();
    m_resumed = resumeIn(m_workspace.growthPlane());
}

bool GrowthRun::resumeIn(std::uint8_t plane)
{
    return beginBurst(resumed(plane), m_workspace.growSettings().generationsPerSecond);
}

/// Where fronts were accepted, it is named what is resumed: its guard is not that of before.
core::Edit GrowthRun::resumed(std::uint8_t plane) const
{
    core::Edit edit = core::ResumeGrowth{.plane = plane};
    const core::EditSession* session = m_workspace.session();
    if (!session || m_workspace.seeds().acceptedFronts().isEmpty())
        return edit;
    // What cannot be named cannot be resumed, and the session says why.
    if (core::nameWhatGrowthReads(edit, session->history(), session->document())) {
        if (auto* growth = edit.as<core::GrowSteps>())
            raiseGuard(growth->guard, growth->criteria.segments, plane, m_workspace);
    }
    return edit;
}

void GrowthRun::goOn(std::uint8_t plane)
{
    if (m_resumed || (m_turns.empty() && plane != m_workspace.growthPlane())) {
        resumeIn(plane);
        return;
    }
    const bool ofOthers = !m_turns.empty() && !activeGrows(m_turns.front(), m_workspace);
    begin(ofOthers ? m_turns : growthTurns(m_workspace),
        m_workspace.growSettings().generationsPerSecond);
}

void GrowthRun::forgetAlarm()
{
    if (!m_running)
        dropTurns();
}

void GrowthRun::dropTurns()
{
    m_turns.clear();
    m_resumed = false;
}

/// Whether what stands open is a burst. Somebody else's stroke or preview has closed it by itself.
bool GrowthRun::isOpen() const
{
    const core::EditSession* session = m_workspace.session();
    return session && (session->isOpen<core::GrowSteps>() || session->isOpen<core::ResumeGrowth>());
}

/// What grows in the burst that stands open and has begun: a growth that is resumed is named by
/// then.
GrowthTurn GrowthRun::openBurst() const
{
    const auto* growth = m_workspace.session()->openEdit()->as<core::GrowSteps>();
    if (!growth)
        return {};
    const core::GrowCriteria& criteria = growth->criteria;
    return {.segments = criteria.segments,
        .lower = criteria.lower,
        .upper = criteria.upper,
        .plane = criteria.plane};
}

void GrowthRun::pause()
{
    if (isOpen())
        m_workspace.session()->extend(core::PauseGrowth{});
    dropTurns();
    finish();
}

void GrowthRun::forget()
{
    m_watch.stop();
    m_running = false;
    dropTurns();
    m_nextTurn = false;
}

bool GrowthRun::beginBurst(const core::Edit& growth, double generationsPerSecond)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return false;
    if (const auto begun = session->begin(growth); !begun) {
        m_workspace.fail(begun.error());
        return false;
    }
    m_running = true;
    Q_EMIT begun();
    core::GrowAdvance advance;
    advance.generationsPerSecond = generationsPerSecond;
    session->extend(advance);
    m_watch.start();
    Q_EMIT changed();
    return true;
}

void GrowthRun::finish()
{
    m_watch.stop();
    m_running = false;
    m_nextTurn = false;
    if (isOpen())
        m_workspace.session()->end(core::Ending::Commit);
    Q_EMIT changed();
}

void GrowthRun::goToNextTurn()
{
    core::EditSession& session = *m_workspace.session();
    if (session.openIsPreview())
        session.closeOpen();
    // The progress is that of the turn before until its row is there.
    if (session.transactionOpen() || !session.idle())
        return;
    // The turns are those of the press; who has gone back or changed something has other plans.
    const core::History& history = session.history();
    if (std::size_t(history.position()) != history.rows().size()
        || history.rows().size() > m_mostRows) {
        dropTurns();
        return finish();
    }
    begin(m_turns, m_pace);
}

void GrowthRun::poll()
{
    const core::EditSession* session = m_workspace.session();
    if (session && m_nextTurn)
        return goToNextTurn();
    // Another edit, undo or export closes a running burst by itself.
    if (!isOpen()) {
        dropTurns();
        return finish();
    }
    // While the burst waits in line, the progress is that of the growth before.
    const core::GrowthProgress progress =
        session->openHasBegun() ? session->growthProgress() : core::GrowthProgress();
    if (progress.open && progress.alarm) {
        const GrowthTurn burst = openBurst();
        finish();
        Q_EMIT alarmed(*progress.alarm, burst);
        return m_workspace.say(tr("The growth has stopped. Is this a leak? Plug, reject or accept "
                                  "it in the panel Growth"));
    }
    if (!progress.open || !progress.atClosure) {
        Q_EMIT changed();
        return;
    }
    finish();
    const GrowthTurn last = m_turns.empty() ? GrowthTurn() : m_turns.front();
    if (!m_turns.empty())
        m_turns.erase(m_turns.begin());
    if (m_turns.empty()) {
        Q_EMIT completed(last);
        return m_workspace.say(tr("The growth is complete: nothing is left within the interval"));
    }
    m_nextTurn = true;
    m_mostRows = session->history().rows().size() + 1;
    m_running = true;
    m_watch.start();
    Q_EMIT changed();
}

} // namespace ui

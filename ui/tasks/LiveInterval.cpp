// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/LiveInterval.h"

#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/session/past/RecentGrowth.h"
#include "ui/settings/GrowSettings.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

namespace ui {

namespace {

constexpr int watchMilliseconds = 15;
/// A growth that has not arrived by then shows how far it came, and gives way to newer bounds.
constexpr qint64 patienceMilliseconds = 200;

} // namespace

LiveInterval::LiveInterval(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    m_watch.setInterval(watchMilliseconds);
    connect(&m_watch, &QTimer::timeout, this, &LiveInterval::poll);
    connect(&workspace, &Workspace::sessionClosing, this, &LiveInterval::close);
}

bool LiveInterval::possible() const
{
    const core::EditSession* session = m_workspace.session();
    return session && session->whyReadOnly().isEmpty() && (m_open || !session->transactionOpen())
        && m_workspace.seeds().past().of(*session).criteria.has_value();
}

void LiveInterval::move(double lower, double upper, const std::optional<std::vector<int>>& segments)
{
    m_wanted = {lower, upper};
    m_segments = segments;
    send(false);
}

void LiveInterval::settle()
{
    if (m_wanted)
        send(true);
    end(core::Ending::Commit);
}

void LiveInterval::cancel()
{
    end(core::Ending::Rollback);
}

void LiveInterval::end(core::Ending ending)
{
    core::EditSession* session = m_workspace.session();
    const bool open = m_open && session && session->transactionOpen();
    close();
    if (open)
        session->end(ending);
}

void LiveInterval::send(bool atOnce)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return close();
    if (m_open && !session->transactionOpen())
        m_open = false; // something else has closed it
    if (!m_open) {
        core::ChangeInterval change;
        if (const auto recent = core::recentCriteria(session->history());
            recent && recent->segments != m_segments) {
            change.criteria = *recent;
            change.criteria.segments = m_segments;
            change.asBefore = false;
        }
        change.criteria.lower = m_wanted->first;
        change.criteria.upper = m_wanted->second;
        change.guard = growthOf(m_workspace.growSettings()).guard;
        if (const auto begun = session->begin(change); !begun) {
            close();
            m_workspace.fail(begun.error());
            return;
        }
        m_open = true;
        m_watch.start();
    } else {
        const bool arrived = !session->growthProgress().running;
        if (!atOnce && !arrived && m_sinceSent.elapsed() < patienceMilliseconds)
            return;
        session->setInterval(m_wanted->first, m_wanted->second);
    }
    m_wanted.reset();
    m_sinceSent.start();
    session->extendGrowth({});
}

void LiveInterval::poll()
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !session->transactionOpen())
        return close();
    if (m_wanted)
        send(false);
    Q_EMIT progressed();
}

void LiveInterval::close()
{
    m_watch.stop();
    m_open = false;
    m_wanted.reset();
    Q_EMIT progressed();
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/LiveInterval.h"

#include "core/session/RecentGrowth.h"
#include "ui/Workspace.h"

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
        && core::recentCriteria(session->history()).has_value();
}

void LiveInterval::move(double lower, double upper)
{
    m_wanted = {lower, upper};
    send(false);
}

void LiveInterval::settle()
{
    if (m_wanted)
        send(true);
    core::EditSession* session = m_workspace.session();
    const bool commit = m_open && session && session->transactionOpen();
    close();
    if (commit)
        session->end(core::Ending::Commit);
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
        change.criteria.lower = m_wanted->first;
        change.criteria.upper = m_wanted->second;
        if (const auto begun = session->begin(change); !begun) {
            close();
            m_workspace.fail(begun.error());
            return;
        }
        m_open = true;
        m_watch.start();
    } else {
        const bool arrived = !session->engine().growthProgress().running;
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

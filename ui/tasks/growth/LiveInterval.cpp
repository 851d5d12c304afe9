// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/LiveInterval.h"

#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/session/past/RecentGrowth.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/StudyTexts.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

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
    return session && session->whyReadOnly().isEmpty()
        && (m_open || !session->isOpen<core::ChangeInterval>())
        && m_workspace.seeds().past().of(*session, m_workspace.growthPlane()).criteria.has_value();
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
    core::EditSession* session = m_workspace.session();
    // However short the drag was, what it suspends is to be seen afterwards.
    if (m_open && !m_comparison && session && session->isOpen<core::ChangeInterval>()
        && m_workspace.viewOptions().suspendedBodies)
        session->questions().compareGrowth([](const auto&) {}, true);
    end(core::Ending::Commit);
}

void LiveInterval::cancel()
{
    end(core::Ending::Rollback);
}

void LiveInterval::end(core::Ending ending)
{
    core::EditSession* session = m_workspace.session();
    const bool open = m_open && session && session->isOpen<core::ChangeInterval>();
    close();
    if (open)
        session->end(ending);
}

void LiveInterval::send(bool atOnce)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return close();
    if (m_open && !session->isOpen<core::ChangeInterval>())
        m_open = false; // something else has closed it
    if (!m_open) {
        core::ChangeInterval change;
        change.criteria.plane = m_workspace.growthPlane();
        if (const auto recent = core::recentCriteria(session->history(), m_workspace.growthPlane());
            recent && recent->segments != m_segments) {
            change.criteria = *recent;
            core::dropGoneFromRange(change.criteria, session->document());
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
        session->extend(core::ToInterval{.lower = m_wanted->first, .upper = m_wanted->second});
    }
    m_wanted.reset();
    m_sinceSent.start();
    session->extend(core::GrowAdvance{});
    ++m_sent;
    m_isWhole = false;
}

void LiveInterval::poll()
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !session->isOpen<core::ChangeInterval>())
        return close();
    if (m_wanted)
        send(false);
    if (m_open)
        compare();
    Q_EMIT progressed();
}

/// The answer waits its turn behind the bounds. So the progress is that of these bounds only after
/// one answer about them: the first shows what they take out, another one all that they come to.
void LiveInterval::compare()
{
    core::EditSession* session = m_workspace.session();
    const bool isAnswered = m_answered == m_sent;
    const bool arrived = isAnswered && !session->growthProgress().running;
    const bool isEarly = m_sinceAsked.isValid() && m_sinceAsked.elapsed() < patienceMilliseconds;
    if (m_asking || m_isWhole || (isAnswered && !arrived && isEarly))
        return;
    m_asking = true;
    m_sinceAsked.start();
    session->questions().compareGrowth(
        [live = QPointer<LiveInterval>(this), drag = m_drag, asked = m_sent, arrived](
            const core::Result<std::optional<core::GrowthComparison>>& comparison) {
            if (live && live->m_drag == drag)
                live->take(comparison, asked, arrived);
        },
        m_workspace.viewOptions().suspendedBodies);
}

void LiveInterval::take(
    const core::Result<std::optional<core::GrowthComparison>>& comparison, int asked, bool arrived)
{
    m_asking = false;
    if (!comparison)
        return; // the growth has not begun yet; then it is asked again
    m_comparison = *comparison;
    m_answered = asked;
    m_isWhole = arrived && asked == m_sent;
    Q_EMIT progressed();
}

QString LiveInterval::words() const
{
    const core::Volume* volume = m_workspace.volume();
    if (!m_open || !m_comparison || !volume)
        return {};
    QStringList parts;
    if (m_comparison->suspended > 0)
        parts << tr("− %1 suspended").arg(millilitreText(*volume, m_comparison->suspended));
    if (m_comparison->reached > 0)
        parts << tr("+ %1").arg(millilitreText(*volume, m_comparison->reached));
    const QString words = parts.isEmpty() ? tr("nothing changes") : parts.join(tr(", "));
    return m_isWhole ? words : words + QStringLiteral(" …");
}

void LiveInterval::close()
{
    m_watch.stop();
    m_open = false;
    m_wanted.reset();
    m_comparison.reset();
    m_asking = false;
    m_isWhole = false;
    ++m_drag;
    Q_EMIT progressed();
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/BackgroundJob.h"

#include "core/base/Guarded.h"
#include "core/base/TaskThread.h"

#include <QCoreApplication>
#include <QPointer>

#include <list>
#include <utility>

namespace ui {

namespace {

/// Of all jobs, those called off among them; touched by the GUI thread only. A connection that does
/// not come about may take seconds to notice that it is no longer wanted.
std::list<core::TaskThread>& threads()
{
    static std::list<core::TaskThread> alive;
    return alive;
}

void awaitThreads()
{
    threads().clear();
}

} // namespace

BackgroundJob::BackgroundJob(QObject* parent)
    : QObject(parent)
{
    static const bool once = [] {
        qAddPostRoutine(awaitThreads);
        return true;
    }();
    Q_UNUSED(once);
}

BackgroundJob::~BackgroundJob()
{
    if (m_progress)
        m_progress->cancel();
}

void BackgroundJob::start(Work work, Failed failed)
{
    cancel();
    // Whatever the thread says reaches this only on the GUI thread, and only while it lives.
    const QPointer<BackgroundJob> guard(this);
    auto mine = std::make_shared<const core::Progress*>(nullptr);
    auto progress =
        std::make_shared<core::Progress>([guard, mine](const QString& step, int done, int total) {
            QMetaObject::invokeMethod(qApp, [guard, teller = *mine, step, done, total] {
                if (guard && guard->m_progress.get() == teller)
                    Q_EMIT guard->progressed(step, done, total);
            });
        });
    *mine = progress.get();
    m_progress = progress;
    const auto tell = [guard, progress](const std::function<void()>& outcome) {
        QMetaObject::invokeMethod(
            qApp,
            [guard, progress, outcome] {
                if (!guard || guard->m_progress != progress)
                    return;
                guard->m_progress.reset();
                outcome();
                if (guard)
                    Q_EMIT guard->ended();
            },
            Qt::QueuedConnection);
    };
    const auto fail = [tell, failed = std::move(failed)](
                          const core::Error& error) { tell([failed, error] { failed(error); }); };
    const core::Result<void> begun = core::guarded([&] {
        threads().emplace_back();
        const auto thread = std::prev(threads().end());
        const auto end = [thread] {
            QMetaObject::invokeMethod(
                qApp, [thread] { threads().erase(thread); }, Qt::QueuedConnection);
        };
        thread->post([does = std::move(work), progress, tell] { tell(does(*progress)); }, fail);
        thread->post(end, [](const core::Error&) {}); // it rests until the program ends, then
    });
    if (!begun)
        fail(begun.error());
}

void BackgroundJob::cancel()
{
    if (!m_progress)
        return;
    m_progress->cancel();
    m_progress.reset();
    Q_EMIT ended();
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/BackgroundJob.h"

#include "ui/texts/ProgressTexts.h"

#include <QCoreApplication>
#include <QPointer>

#include <list>
#include <utility>

namespace ui {

namespace {

/// Of all jobs, those called off among them; touched by the GUI thread only. A connection that does
/// not come about may take seconds to notice that it is no longer wanted.
std::list<core::Background>& threads()
{
    static std::list<core::Background> alive;
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
    m_task.cancel();
}

void BackgroundJob::start(Work work, Failed failed)
{
    cancel();
    const auto mine = threads().emplace(threads().end());
    m_task = mine->start(
        this, std::move(work),
        [this, failed = std::move(failed)](const core::Result<std::function<void()>>& outcome) {
            const QPointer<BackgroundJob> guard(this);
            if (outcome)
                (*outcome)();
            else
                failed(outcome.error());
            if (guard)
                Q_EMIT ended();
        },
        [this](core::ProgressStep step, int done, int total) {
            Q_EMIT progressed(progressText(step), done, total);
        });
    mine->start(
        qApp, [] {}, [mine](const core::Result<void>&) { threads().erase(mine); });
}

void BackgroundJob::cancel()
{
    if (!running())
        return;
    m_task.cancel();
    Q_EMIT ended();
}

} // namespace ui

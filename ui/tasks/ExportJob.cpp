// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/ExportJob.h"

#include "core/base/Guarded.h"

#include <utility>

namespace ui {

struct ExportJob::Work {
    std::function<core::Result<core::ExportReport>(const core::Progress&)> write;
    core::Progress progress;

    explicit Work(core::Progress::Listener listener)
        : progress(std::move(listener))
    {
    }
};

ExportJob::ExportJob(QObject* parent)
    : QObject(parent)
{
}

ExportJob::~ExportJob()
{
    cancel();
    m_thread.reset();
}

void ExportJob::start(std::function<core::Result<core::ExportReport>(const core::Progress&)> write)
{
    if (running())
        return;
    // Signals across threads: the listener runs on the worker, its connections are queued.
    m_work = std::make_shared<Work>([this](const QString& step, int done, int total) {
        QMetaObject::invokeMethod(
            this, [this, step, done, total] { Q_EMIT progressed(step, done, total); },
            Qt::QueuedConnection);
    });
    m_work->write = std::move(write);
    const auto tell = [this](const core::Result<core::ExportReport>& outcome) {
        QMetaObject::invokeMethod(
            this, [this, outcome] { take(outcome); }, Qt::QueuedConnection);
    };
    const core::Result<void> begun = core::guarded([&] {
        m_thread.emplace();
        m_thread->post([tell, work = m_work] { tell(work->write(work->progress)); },
            [tell](const core::Error& error) { tell(tl::unexpected(error)); });
    });
    if (!begun)
        tell(tl::unexpected(begun.error()));
}

void ExportJob::take(const core::Result<core::ExportReport>& outcome)
{
    m_thread.reset();
    m_work.reset();
    if (outcome)
        Q_EMIT finished(*outcome);
    else
        Q_EMIT failed(outcome.error());
}

void ExportJob::cancel()
{
    if (m_work)
        m_work->progress.cancel();
}

bool ExportJob::running() const
{
    return m_work != nullptr;
}

} // namespace ui

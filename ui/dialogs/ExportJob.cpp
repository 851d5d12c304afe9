// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/ExportJob.h"

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
    if (m_thread)
        m_thread->wait();
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
    m_thread.reset(QThread::create([this, work = m_work] {
        auto result = work->write(work->progress);
        QMetaObject::invokeMethod(
            this,
            [this, outcome = std::move(result)] {
                m_thread->wait();
                m_work.reset();
                if (outcome)
                    Q_EMIT finished(*outcome);
                else
                    Q_EMIT failed(outcome.error());
            },
            Qt::QueuedConnection);
    }));
    m_thread->start();
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

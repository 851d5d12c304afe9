// SPDX-License-Identifier: Apache-2.0
#include "ui/pacs/BackgroundJob.h"

#include <QCoreApplication>
#include <QPointer>
#include <QSet>
#include <QThread>

#include <utility>

namespace ui {

namespace {

/// Of all jobs, those called off among them; touched by the GUI thread only. A connection that does
/// not come about may take seconds to notice that it is no longer wanted.
QSet<QThread*>& threads()
{
    static QSet<QThread*> alive;
    return alive;
}

void awaitThreads()
{
    for (QThread* thread : std::as_const(threads()))
        thread->wait();
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

void BackgroundJob::start(Work work)
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
    QThread* thread = QThread::create([guard, progress, does = std::move(work)] {
        std::function<void()> tell = does(*progress);
        QMetaObject::invokeMethod(qApp, [guard, progress, tell = std::move(tell)] {
            if (!guard || guard->m_progress != progress)
                return;
            guard->m_progress.reset();
            tell();
            if (guard)
                Q_EMIT guard->ended();
        });
    });
    threads().insert(thread);
    connect(thread, &QThread::finished, qApp, [thread] {
        threads().remove(thread);
        thread->wait();
        delete thread;
    });
    thread->start();
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

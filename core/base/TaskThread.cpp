// SPDX-License-Identifier: Apache-2.0
#include "core/base/TaskThread.h"

#include "core/base/Guarded.h"
#include "core/base/trace/Trace.h"

#include <exception>
#include <system_error>
#include <utility>

namespace core {

TaskThread::TaskThread()
    : m_thread([this] { work(); })
{
}

TaskThread::~TaskThread()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

void TaskThread::post(std::function<void()> task, std::function<void(const Error&)> failed)
{
    {
        const std::lock_guard lock(m_mutex);
        m_tasks.push_back({.carryOut = std::move(task), .failed = std::move(failed)});
    }
    m_changed.notify_all();
}

void TaskThread::run(const std::function<void()>& task)
{
    std::mutex mutex;
    std::condition_variable changed;
    bool done = false;
    std::exception_ptr thrown;
    post(
        [&] {
            try {
                task();
            } catch (...) {
                thrown = std::current_exception();
            }
            const std::lock_guard lock(mutex);
            done = true;
            changed.notify_all();
        },
        [](const Error&) {});
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return done; });
    if (thrown)
        std::rethrow_exception(thrown);
}

void TaskThread::finish()
{
    run([] {});
}

void TaskThread::work()
{
    if (Trace::isOn())
        static_cast<void>(guarded([] { Trace::nameThread("tasks"); }));
    std::unique_lock lock(m_mutex);
    while (true) {
        m_changed.wait(lock, [this] { return m_ending || !m_tasks.empty(); });
        if (m_tasks.empty())
            return;
        {
            const Task task = std::move(m_tasks.front());
            m_tasks.pop_front();
            lock.unlock();
            if (const Result<void> done = guarded(task.carryOut); !done)
                task.failed(done.error());
        }
        lock.lock();
    }
}

LoneTask::LoneTask(std::function<void()> task)
    : m_task(std::move(task))
{
    try {
        m_thread.emplace();
    } catch (const std::system_error&) {
        return;
    }
    m_thread->post(
        [this] {
            try {
                m_task();
            } catch (...) {
                m_thrown = std::current_exception();
            }
        },
        [](const Error&) {});
}

void LoneTask::finish()
{
    if (!m_thread)
        return m_task();
    m_thread.reset();
    if (m_thrown)
        std::rethrow_exception(m_thrown);
}

} // namespace core

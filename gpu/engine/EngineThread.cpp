// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/EngineThread.h"

#include "core/base/trace/Trace.h"
#include "gpu/gl/DebugOutput.h"
#include "gpu/gl/GpuTrace.h"
#include "gpu/gl/context/CallsDriver.h"

#include <future>
#include <utility>

namespace gpu {

EngineThread::EngineThread(std::unique_ptr<GlContext> context)
    : m_context(std::move(context))
{
}

EngineThread::~EngineThread()
{
    if (!m_thread.joinable())
        return;
    {
        const std::lock_guard lock(m_mutex);
        m_stopping = true;
    }
    m_wakeUp.notify_one();
    m_thread.join();
}

core::Result<void> EngineThread::start()
{
    std::promise<bool> current;
    std::future<bool> isCurrent = current.get_future();
    m_thread = std::thread([this, &current] {
        const CallsDriver calls;
        const bool made = m_context->makeCurrent();
        if (made)
            DebugOutput::install();
        current.set_value(made);
        if (!made)
            return;
        if (core::Trace::isOn())
            core::Trace::nameThread("engine");
        {
            const GpuTrace trace;
            loop();
        }
        m_context->doneCurrent();
    });
    if (!isCurrent.get()) {
        m_thread.join();
        return core::failure(core::ErrorCode::GraphicsUnavailable, QStringLiteral("OpenGL"),
            core::Clause::saying("the context cannot be made current"));
    }
    return {};
}

void EngineThread::post(Job job)
{
    {
        const std::lock_guard lock(m_mutex);
        m_jobs.push_back(std::move(job));
    }
    m_wakeUp.notify_one();
}

void EngineThread::run(const Job& job)
{
    if (std::this_thread::get_id() == m_thread.get_id()) {
        job();
        return;
    }
    std::promise<void> done;
    post([&] {
        try {
            job();
            done.set_value();
        } catch (...) {
            done.set_exception(std::current_exception());
        }
    });
    done.get_future().get();
}

void EngineThread::wake()
{
    {
        const std::lock_guard lock(m_mutex);
        m_woken = true;
    }
    m_wakeUp.notify_one();
}

void EngineThread::wakeAt(Clock::time_point time)
{
    if (!m_alarm || time < *m_alarm)
        m_alarm = time;
}

void EngineThread::setSlices(Slice edits, Slice frames)
{
    m_edits = std::move(edits);
    m_frames = std::move(frames);
}

void EngineThread::loop()
{
    bool busy = false;
    std::unique_lock lock(m_mutex);
    for (;;) {
        const auto due = [this] { return !m_jobs.empty() || m_woken || m_stopping; };
        if (!busy && m_alarm)
            m_wakeUp.wait_until(lock, *m_alarm, due);
        else if (!busy)
            m_wakeUp.wait(lock, due);
        if (m_alarm && Clock::now() >= *m_alarm)
            m_alarm.reset();
        m_woken = false;
        while (!m_jobs.empty()) {
            const Job job = std::move(m_jobs.front());
            m_jobs.pop_front();
            lock.unlock();
            job();
            lock.lock();
        }
        if (m_stopping)
            return;
        lock.unlock();
        busy = m_edits && m_edits();
        busy = (m_frames && m_frames()) || busy;
        lock.lock();
    }
}

} // namespace gpu

// SPDX-License-Identifier: Apache-2.0
#include "core/base/Background.h"

#include "core/base/Guarded.h"
#include "core/base/HandedOver.h"
#include "core/base/trace/Trace.h"

#include <QCoreApplication>
#include <QPointer>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>

namespace core {

struct Background::State : std::enable_shared_from_this<Background::State> {
    State(QObject& here, QObject* context, const Progress::Listener& progressed)
        : m_here(here)
        , m_context(context)
        , m_progress(progressed ? fromThere(progressed) : Progress::Listener())
    {
    }

    [[nodiscard]] const Progress& progress() const { return m_progress; }
    void stop() { m_progress.cancel(); }
    void cancel()
    {
        stop();
        // It may be large, and whoever cancels may want its room.
        const Completion dropped = end();
    }
    [[nodiscard]] bool isOver() const
    {
        const std::lock_guard lock(m_mutex);
        return m_over;
    }

    /// Of the task's thread.
    void callMeanwhile(Completion completion)
    {
        QMetaObject::invokeMethod(
            &m_here,
            [state = shared_from_this(), completion = std::move(completion),
                handed = HandedOver()] {
                handed.takeOver();
                if (!state->isOver() && state->m_context)
                    completion();
            },
            Qt::QueuedConnection);
    }
    /// Until it is told; what was cancelled meanwhile goes here, before another task begins.
    void keep(Completion completion)
    {
        const std::lock_guard lock(m_mutex);
        if (!m_over)
            m_completion.swap(completion);
    }
    void completeNow()
    {
        const Completion completion = end();
        if (completion && m_context)
            completion();
    }

private:
    [[nodiscard]] Progress::Listener fromThere(const Progress::Listener& progressed)
    {
        return [this, progressed](ProgressStep step, int done, int total) {
            callMeanwhile([progressed, step, done, total] { progressed(step, done, total); });
        };
    }
    [[nodiscard]] Completion end()
    {
        const std::lock_guard lock(m_mutex);
        m_over = true;
        return std::exchange(m_completion, {});
    }

    QObject& m_here;
    QPointer<QObject> m_context; ///< not looked at by the task's thread
    Progress m_progress;
    mutable std::mutex m_mutex;
    Completion m_completion; ///< under the mutex
    bool m_over = false; ///< told or cancelled; under the mutex
};

Background::Task::Task(std::shared_ptr<State> state)
    : m_state(std::move(state))
{
}

void Background::Task::cancel()
{
    if (m_state)
        m_state->cancel();
}

void Background::Task::stop()
{
    if (m_state)
        m_state->stop();
}

bool Background::Task::running() const
{
    return m_state && !m_state->isOver();
}

Background::~Background()
{
    cancel();
}

void Background::cancel()
{
    for (const std::shared_ptr<State>& state : m_states)
        state->cancel();
}

bool Background::busy() const
{
    return std::any_of(m_states.begin(), m_states.end(),
        [](const std::shared_ptr<State>& state) { return !state->isOver(); });
}

void Background::finish()
{
    if (m_thread)
        m_thread->finish();
    QCoreApplication::sendPostedEvents(&m_here);
}

Background::Task Background::begin(QObject* context, Work work,
    std::function<void(const Error&)> failed, Progress::Listener progressed,
    const std::type_info& type)
{
    Q_ASSERT(context && context->thread() == m_here.thread());
    std::erase_if(m_states, [](const std::shared_ptr<State>& state) { return state->isOver(); });
    const auto state = std::make_shared<State>(m_here, context, progressed);
    m_states.push_back(state);
    const auto fail = [this, state, failed = std::move(failed)](const Error& error) {
        completeLater(state, [failed, error] { failed(error); });
    };
    const Result<void> begun = guarded([&] {
        if (!m_thread)
            m_thread.emplace();
        m_thread->post(
            [this, state, work = std::move(work), name = TraceName(type)]() mutable {
                const TraceSpan span("task", name);
                carryOut(state, std::exchange(work, {}));
            },
            fail);
    });
    if (!begun)
        fail(begun.error());
    return Task(state);
}

void Background::carryOut(const std::shared_ptr<State>& state, Work work)
{
    Completion completion;
    if (!state->isOver())
        completion = work(state->progress(),
            [&state](Completion meanwhile) { state->callMeanwhile(std::move(meanwhile)); });
    work = {};
    completeLater(state, std::move(completion));
}

void Background::completeLater(const std::shared_ptr<State>& state, Completion completion)
{
    constexpr std::chrono::milliseconds pause{5};
    state->keep(std::move(completion));
    const auto queue = [this, &state] {
        QMetaObject::invokeMethod(
            &m_here,
            [background = this, state, handed = HandedOver()] {
                handed.takeOver();
                background->settle(state);
            },
            Qt::QueuedConnection);
    };
    // One that is lost would leave whoever waits for it waiting for ever.
    while (!guarded(queue) && !state->isOver())
        std::this_thread::sleep_for(pause);
}

void Background::settle(const std::shared_ptr<State>& state)
{
    // Whoever is told may destroy this.
    const QPointer<QObject> here(&m_here);
    state->completeNow();
    if (!here || m_states.empty() || m_states.back() != state || busy())
        return;
    m_states.clear();
    m_thread.reset(); // it has nothing left to do
}

} // namespace core

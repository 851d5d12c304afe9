// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/TaskThread.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

namespace core {

/// Runs tasks on a background thread, one after the other, and reports their results on the thread
/// in which this object lives, through its event loop. A result is never reported during start(),
/// and not after the task was cancelled or its context destroyed. The thread exists while there is
/// work.
///
/// Declare it last among the members that its tasks use, since it ends the tasks. All functions are
/// called on the thread on which it was created.
class Background {
    struct State;

public:
    /// Something to be done on the thread in which Background lives.
    using Completion = std::function<void()>;
    /// Lets a task report something before it is done, in order with its progress. Called on the
    /// task's thread.
    using Meanwhile = std::function<void(Completion)>;

    /// A task that was started; the task does not depend on this object. Copies refer to the same
    /// task.
    class Task {
    public:
        Task() = default; ///< none
        /// Suppresses all further reports; the result is destroyed at once.
        void cancel();
        /// Asks the task to end early. Its result is still reported.
        void stop();
        /// Whether its result will be reported.
        [[nodiscard]] bool running() const;

    private:
        friend class Background;
        explicit Task(std::shared_ptr<State> state);
        std::shared_ptr<State> m_state;
    };

    Background() = default;
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    /// Cancels all tasks and waits until the running one has ended. Reports nothing.
    ~Background();

    /// Starts a task.
    /// @param context lives in this thread; nothing is reported after it was destroyed
    /// @param does called on the other thread with Progress and Meanwhile, as far as it takes them;
    /// returns a Result, another value or nothing
    /// @param done receives that as a Result; an exception of @p does is its error, and so is
    /// OutOfMemory if no thread can be started
    /// @param progressed receives the progress, on this thread
    /// What @p does and @p done hold may be destroyed on either thread.
    template <class Does, class Done>
    Task start(QObject* context, Does does, Done done, Progress::Listener progressed = {})
    {
        using Outcome = typename OutcomeOf<decltype(called(
            does, std::declval<const Progress&>(), std::declval<const Meanwhile&>()))>::Type;
        return begin(
            context,
            [does = std::move(does), done](
                const Progress& progress, const Meanwhile& meanwhile) mutable -> Completion {
                std::shared_ptr<Outcome> outcome;
                if constexpr (std::is_void_v<decltype(called(does, progress, meanwhile))>) {
                    called(does, progress, meanwhile);
                    outcome = std::make_shared<Outcome>();
                } else {
                    outcome = std::make_shared<Outcome>(called(does, progress, meanwhile));
                }
                return [done, outcome] { done(std::move(*outcome)); };
            },
            [done](const Error& error) { done(Outcome(tl::unexpected<Error>(error))); },
            std::move(progressed), typeid(Does));
    }
    /// The same after cancelling everything started before.
    template <class Does, class Done>
    Task replace(QObject* context, Does does, Done done, Progress::Listener progressed = {})
    {
        cancel();
        return start(context, std::move(does), std::move(done), std::move(progressed));
    }
    /// Cancels everything that was started.
    void cancel();
    /// Waits until everything that was started is done, and reports the results before it returns.
    void finish();
    /// Whether anything will be reported.
    [[nodiscard]] bool busy() const;

private:
    using Work = std::function<Completion(const Progress&, const Meanwhile&)>;
    template <class Returned> struct OutcomeOf {
        using Type = Result<Returned>;
    };
    template <class Value> struct OutcomeOf<Result<Value>> {
        using Type = Result<Value>;
    };

    template <class Does>
    static auto called(Does& does, const Progress& progress, const Meanwhile& meanwhile)
    {
        if constexpr (std::is_invocable_v<Does&, const Progress&, const Meanwhile&>)
            return does(progress, meanwhile);
        else if constexpr (std::is_invocable_v<Does&, const Progress&>)
            return does(progress);
        else
            return does();
    }

    /// @param type of what the task does: its name in a trace
    Task begin(QObject* context, Work work, std::function<void(const Error&)> failed,
        Progress::Listener progressed, const std::type_info& type);
    void carryOut(const std::shared_ptr<State>& state, Work work);
    void completeLater(const std::shared_ptr<State>& state, Completion completion);
    void settle(const std::shared_ptr<State>& state);

    QObject m_here; ///< receives events from the thread; they end with it
    std::vector<std::shared_ptr<State>> m_states; ///< in the order of starting; some are over
    std::optional<TaskThread> m_thread; ///< last, since it uses all of the above
};

} // namespace core

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
#include <utility>
#include <vector>

namespace core {

/// Work beside the thread that this lives in, one task after the other as they were started, on a
/// thread that is there while there is work. What comes of a task is told here, by the event loop:
/// never while start() is under way, never once the task was cancelled or its context is gone.
///
/// Declare it last among the members that its tasks use: they end with it. All functions are of the
/// thread that it was made on.
class Background {
    struct State;

public:
    /// Something to be carried out on the thread that Background lives in.
    using Tell = std::function<void()>;
    /// Has a task tell something before it is done, as its progress is told. Of its thread.
    using Meanwhile = std::function<void(Tell)>;

    /// One that was started; it goes on without this. Copies are of the same task.
    class Task {
    public:
        Task() = default; ///< none
        /// Nothing of it is told any more; what came of it goes at once.
        void cancel();
        /// Asks it to end early. What comes of it then is told.
        void stop();
        /// What comes of it will be told.
        [[nodiscard]] bool running() const;

    private:
        friend class Background;
        explicit Task(std::shared_ptr<State> state);
        std::shared_ptr<State> m_state;
    };

    Background() = default;
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    /// Cancels, and waits until the task that is under way has noticed. Tells nothing.
    ~Background();

    /// @param context lives in the thread of this; without it nothing is told
    /// @param does called on the other thread with as many as it takes of its Progress and
    ///     Meanwhile; returns a Result, another value or nothing
    /// @param done takes that as a Result; what @p does threw is its error, and OutOfMemory where
    ///     there is no thread for it
    /// @param progressed told of its progress, here
    /// What @p does and @p done hold may end on either thread.
    template <class Does, class Done>
    Task start(QObject* context, Does does, Done done, Progress::Listener progressed = {})
    {
        using Outcome = typename OutcomeOf<decltype(called(
            does, std::declval<const Progress&>(), std::declval<const Meanwhile&>()))>::Type;
        return begin(
            context,
            [does = std::move(does), done](
                const Progress& progress, const Meanwhile& meanwhile) mutable -> Tell {
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
            std::move(progressed));
    }
    /// The same; whatever was started before is cancelled.
    template <class Does, class Done>
    Task replace(QObject* context, Does does, Done done, Progress::Listener progressed = {})
    {
        cancel();
        return start(context, std::move(does), std::move(done), std::move(progressed));
    }
    /// All that was started.
    void cancel();
    /// Waits until all that was started is done, and tells it before it returns.
    void finish();
    /// Something of it will be told.
    [[nodiscard]] bool busy() const;

private:
    using Work = std::function<Tell(const Progress&, const Meanwhile&)>;
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

    Task begin(QObject* context, Work work, std::function<void(const Error&)> failed,
        Progress::Listener progressed);
    void carryOut(const std::shared_ptr<State>& state, Work work);
    void tellLater(const std::shared_ptr<State>& state, Tell tell);
    void settle(const std::shared_ptr<State>& state);

    QObject m_here; ///< what comes from the thread comes as its events, which end with it
    std::vector<std::shared_ptr<State>> m_states; ///< by start; some are over
    std::optional<TaskThread> m_thread; ///< last: it uses all of the above
};

} // namespace core

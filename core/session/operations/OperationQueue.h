// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/questions/QuestionLine.h"
#include "core/session/state/Operation.h"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace core {

class AbortableWork;
class SurfaceOperation;

/// The queue of everything that a session was asked to do: edits, walks through the history and
/// questions. It carries them out one after the other as engine and worker answer, and notifies
/// listeners. Only settle(), waitForEngine() and the destructor block. Part of EditSession; one
/// thread.
class OperationQueue final : public QuestionLine {
public:
    /// @param file null: history in memory only
    /// @param wakeUp as in EditSession::Options
    OperationQueue(EditEngine& engine, Volume volume, std::unique_ptr<SessionFile> file,
        std::function<void()> wakeUp);
    /// Ends what is open as is usual for it (OpenManner), and waits for the disk.
    ~OperationQueue() override;

    void submit(std::unique_ptr<Operation> operation) override;
    void ask(EngineCommand question, Answer answer) override;

    /// The open operation, which the user continues until it ends; null: none.
    [[nodiscard]] OpenOperation* interactive() const;
    /// The edit of the surface that is running; null: another operation, or none.
    [[nodiscard]] SurfaceOperation* runningSurface() const;
    /// The running operation, if it is of a kind that can be aborted; null: another one, or none.
    [[nodiscard]] AbortableWork* runningAbortable() const;
    void end(OpenOperation& stroke, Ending ending);
    /// Ends what stands open without a pen, as is usual for it (OpenManner).
    void closeOpen() override;

    void poll();
    void waitForEngine() override;
    /// Blocks until nothing is left to do. @return the first failure since the last call
    Result<void> settle();
    /// To be called before endUnheard(), while failures can still be reported: ends what stands
    /// open without a pen, aborts work for which a session that ends does not wait (without
    /// reporting that), and settles.
    Result<void> endWork();
    /// What the destructor does first: from here on neither listeners nor callers receive anything.
    void endUnheard();

    /// Blocks until the file holds all that it was given so far, or the disk does not take it; then
    /// reports that.
    void finishWriting();

    /// Whether nothing is running or waiting.
    [[nodiscard]] bool idle() const { return m_operations.empty(); }
    /// Checks whether an edit can be carried out after everything that is waiting; what cannot be
    /// decided yet is accepted.
    [[nodiscard]] Result<void> check(const Edit& edit) const;
    [[nodiscard]] Document foreseen() const override;
    /// As in EditSession.
    [[nodiscard]] std::optional<RowId> foreseenPosition() const;

    [[nodiscard]] SessionState& state() { return m_state; }
    [[nodiscard]] const SessionState& state() const { return m_state; }

    void setListener(std::function<void(const DocumentChange&)> listener);
    void setErrorListener(std::function<void(const Error&)> listener);
    /// Passes the news of the state to the listeners.
    void notifyListeners();
    /// Runs @p work, which passes input to the open operation. If it throws, the operation is taken
    /// back; if that is impossible, the session is lost (SessionState::lose()).
    void guard(const std::function<void()>& work);

private:
    void noticeTrouble();
    void takeBack(const Error& error);
    void abortLongWork();
    Result<void> waitUntilSettled();
    void advance();
    void askBehindOpen();
    bool collect();
    void takeChunks();
    void take(EngineResult&& result);
    void take(CommitWorker::Report&& report);
    [[nodiscard]] bool nothingAhead() const;
    [[nodiscard]] bool settled() const
    {
        return nothingAhead() && m_answers.empty() && !m_state.owes();
    }

    SessionState m_state;
    std::function<void()> m_wakeUp;
    std::function<void(const DocumentChange&)> m_listener;
    std::function<void(const Error&)> m_errorListener;
    std::deque<std::unique_ptr<Operation>> m_operations; ///< the first one is running
    bool m_started = false; ///< whether the first one was started
    bool m_advancing = false;
    bool m_polling = false;
    bool m_ending = false; ///< endWork() is at work
    bool m_closing = false; ///< nobody receives answers any more
    bool m_troubled = false; ///< the user was told that the file cannot be written
    std::map<Ticket, Answer> m_answers; ///< to questions that the engine has received
};

} // namespace core

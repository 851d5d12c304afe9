// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/operations/VoxelOperation.h"
#include "core/session/questions/QuestionLine.h"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace core {

/// What a session was asked to do, in line: edits, walks through the history and questions. Carries
/// them out one after the other as engine and worker answer, and tells what came of it. Part of
/// EditSession; one thread. Nothing here waits but settle() and the destructor.
class OperationQueue final : public QuestionLine {
public:
    /// @param file null: history in memory only
    /// @param wakeUp as in EditSession::Options
    OperationQueue(EditEngine& engine, Volume volume, std::unique_ptr<SessionFile> file,
        std::function<void()> wakeUp);
    /// Commits a growth or peel under way, rolls a stroke back, and waits for the disk.
    ~OperationQueue() override;

    void submit(std::unique_ptr<Operation> operation) override;
    void ask(EngineCommand question, Answer answer) override;

    /// The stroke under the pen or the growth that runs; null: none.
    [[nodiscard]] OpenOperation* interactive() const;
    /// The same, if it is one of voxels.
    [[nodiscard]] VoxelOperation* interactiveVoxels() const;
    void end(OpenOperation& stroke, Ending ending);
    /// A growth that runs is committed at its generation, an open peel at its depth; a preview is
    /// taken back.
    void closeGrowth() override;

    void poll();
    void waitForEngine() override;
    /// Waits. @return the first failure since it was called last
    Result<void> settle();

    /// Nothing is under way or waits.
    [[nodiscard]] bool idle() const { return m_operations.empty(); }
    /// Whether an edit can be carried out after what waits; what cannot be told is let through.
    [[nodiscard]] Result<void> check(const Edit& edit) const;
    [[nodiscard]] Document foreseen() const override;

    [[nodiscard]] SessionState& state() { return m_state; }
    [[nodiscard]] const SessionState& state() const { return m_state; }

    void setListener(std::function<void(const DocumentChange&)> listener);
    void setErrorListener(std::function<void(const Error&)> listener);
    /// Tells the listeners what the state has to tell.
    void tellNews();
    /// For what is told to the operation that is open. What is thrown there takes that back; where
    /// it cannot be, the session is lost (SessionState::lose()).
    void guard(const std::function<void()>& work);

private:
    void noticeTrouble();
    void takeBack(const Error& error);
    Result<void> waitUntilSettled();
    void advance();
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
    std::deque<std::unique_ptr<Operation>> m_operations; ///< the first one is under way
    bool m_started = false; ///< the first one is
    bool m_advancing = false;
    bool m_polling = false;
    bool m_closing = false; ///< nobody is there to be answered
    bool m_troubled = false; ///< the user knows that the file cannot be written
    std::map<Ticket, Answer> m_answers; ///< to questions that are with the engine
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/TaskThread.h"
#include "core/chunks/ChunkMap.h"
#include "core/chunks/ChunkStage.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/EditEngine.h"
#include "core/history/History.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace core {

/// The chunks of one division, kept until another one is wanted. The engine is asked for the codes
/// of its box; the rest is worked out on a thread of its own. The session's thread calls.
class ChunkWorker {
public:
    using Map = std::shared_ptr<const ChunkMap>;

    /// @param wakeUp called on the worker's thread when collect() has something
    ChunkWorker(EditEngine& engine, const VolumeGeometry& geometry, std::function<void()> wakeUp);
    /// What is under way is given up.
    ~ChunkWorker();
    ChunkWorker(const ChunkWorker&) = delete;
    ChunkWorker& operator=(const ChunkWorker&) = delete;

    /// Begins with the division of a row, unless it is there or under way; another one is dropped.
    /// What failed is not tried again.
    void want(RowId row, const Chunks& edit);
    /// The chunks of a row's division; null: they are not there (yet).
    [[nodiscard]] Map map(RowId row) const;
    /// Why they never will be: the engine's reasons, OutOfMemory, Cancelled.
    [[nodiscard]] std::optional<Error> whyNot(RowId row) const;
    /// The same of what was wanted last.
    [[nodiscard]] const std::optional<Error>& lastFailure() const { return m_failure; }
    /// What failed may be tried again.
    void forgetFailure();
    /// None: nothing is under way.
    [[nodiscard]] std::optional<ChunkStage> stage() const;
    /// What is under way is given up: it fails, which only those are told who wait for it.
    void cancel();

    /// Waits until what was begun on its thread is done.
    void finish() { m_thread.finish(); }

    /// @return whether it was the answer to a question of its own
    bool take(const EngineResult& result);
    /// @return whether want() led to something since it was called last
    bool collect();
    /// A failure that nobody was told of yet; it is told of now.
    [[nodiscard]] std::optional<Error> takeUntold();

private:
    struct Job;

    [[nodiscard]] Result<void> begin(const Chunks& edit);
    void ask(const std::shared_ptr<Job>& job);
    void workOut(Job& job);
    void setOutcome(Job& job, Result<Map> outcome);
    [[nodiscard]] Result<Map> mapOf(Job& job) const;
    void fail(const Error& error);
    void drop();

    EditEngine& m_engine;
    VolumeGeometry m_geometry;
    std::function<void()> m_wakeUp;
    RowId m_row = 0; ///< 0: nothing was wanted
    std::shared_ptr<Job> m_job; ///< under way
    Map m_map;
    std::optional<Error> m_failure;
    bool m_isUntold = false; ///< m_failure
    bool m_news = false; ///< that collect() has not told of
    std::map<Ticket, std::shared_ptr<Job>> m_asked;
    TaskThread m_thread; ///< last: it uses all of the above
};

} // namespace core

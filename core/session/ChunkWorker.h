// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/TaskThread.h"
#include "core/chunks/ChunkMap.h"
#include "core/edits/ChunkVoxels.h"
#include "core/engine/EditEngine.h"
#include "core/history/History.h"

#include <functional>
#include <map>
#include <memory>
#include <mutex>
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
    void want(RowId row, const Chunks& edit);
    /// The chunks of a row's division; null: they are not there (yet).
    [[nodiscard]] Map map(RowId row) const;
    /// Why they never will be.
    [[nodiscard]] std::optional<Error> whyNot(RowId row) const;

    /// @return whether it was the answer to a question of its own
    bool take(const EngineResult& result);
    /// @return whether want() led to something since it was called last
    bool collect();

private:
    /// From the questions to the answer; the thread's from the last answered question on.
    struct Job {
        OwnedBox owned;
        std::vector<std::uint16_t> codes{};
        std::size_t questions = 0; ///< that are not answered
        Progress progress{};
        std::optional<Result<Map>> outcome{}; ///< under m_mutex
    };

    void ask(const std::shared_ptr<Job>& job);
    void workOut(Job& job);
    void drop();

    EditEngine& m_engine;
    VolumeGeometry m_geometry;
    std::function<void()> m_wakeUp;
    RowId m_row = 0; ///< 0: nothing was wanted
    std::shared_ptr<Job> m_job; ///< under way
    Map m_map;
    std::optional<Error> m_failure;
    bool m_news = false; ///< that collect() has not told of
    std::map<Ticket, std::shared_ptr<Job>> m_asked;
    mutable std::mutex m_mutex;
    TaskThread m_thread; ///< last: it uses all of the above
};

} // namespace core

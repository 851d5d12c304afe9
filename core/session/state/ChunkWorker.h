// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/TaskThread.h"
#include "core/chunks/ChunkMap.h"
#include "core/chunks/ChunkStage.h"
#include "core/chunks/CoarseChunks.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/Ticket.h"
#include "core/history/History.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace core {

class EditEngine;
struct EngineResult;

/// Computes the chunks of one division and keeps them until another one is requested. The engine
/// provides the codes of its box; the rest is computed on a thread of its own. Called from the
/// session's thread.
class ChunkWorker {
public:
    using Map = std::shared_ptr<const ChunkMap>;
    using Coarse = std::shared_ptr<const CoarseChunks>;
    /// Voxels of a box whose chunks take so long that coarse ones are computed first.
    static constexpr std::int64_t fewestForCoarse = std::int64_t(1) << 22;

    /// @param wakeUp called on the worker's thread when collect() has something
    ChunkWorker(EditEngine& engine, const VolumeGeometry& geometry, std::function<void()> wakeUp,
        std::int64_t coarseFrom = fewestForCoarse);
    /// Cancels a running computation.
    ~ChunkWorker();
    ChunkWorker(const ChunkWorker&) = delete;
    ChunkWorker& operator=(const ChunkWorker&) = delete;

    /// Begins to compute the division of a row, unless it is available or being computed; any other
    /// one is dropped. A failed computation is not repeated.
    void want(RowId row, const DivideSegment& edit);
    /// The chunks of a row's division; null: not available (yet).
    [[nodiscard]] Map map(RowId row) const;
    /// Roughly what they will be, of a large box, while they are being computed; null: not known.
    [[nodiscard]] Coarse coarse(RowId row) const;
    /// Why they cannot be computed: the engine's reasons, OutOfMemory, Cancelled.
    [[nodiscard]] std::optional<Error> whyNot(RowId row) const;
    /// The same for the last request.
    [[nodiscard]] const std::optional<Error>& lastFailure() const { return m_failure; }
    /// Allows a failed computation to be tried again.
    void forgetFailure();
    /// The progress; none: nothing is being computed.
    [[nodiscard]] std::optional<ChunkStage> stage() const;
    /// Cancels the computation: it fails, which is reported only to those who wait for it.
    void cancel();

    /// Blocks until the requested edit is unpacked; then collect() asks the engine for its box.
    /// Cost: that of unpacking an edit.
    void finishPreparing();
    /// Blocks until the work that its thread has begun is done.
    void finish() { m_thread.finish(); }

    /// @return whether the result answered one of its own questions
    bool take(const EngineResult& result);
    /// @return whether a computation ended since the last call, or coarse chunks have come
    bool collect();
    /// Returns a failure that was not reported yet, and marks it as reported.
    [[nodiscard]] std::optional<Error> takeUnreported();

private:
    struct Job;

    void prepare(Job& job, const DivideSegment& edit) const;
    void ask(const std::shared_ptr<Job>& job);
    void workOut(Job& job);
    void workOutRoughly(Job& job) const;
    void setOutcome(Job& job, Result<Map> outcome) const;
    [[nodiscard]] Result<Map> mapOf(Job& job) const;
    void fail(const Error& error);
    void drop();

    EditEngine& m_engine;
    VolumeGeometry m_geometry;
    std::function<void()> m_wakeUp;
    std::int64_t m_coarseFrom;
    RowId m_row = 0; ///< 0: nothing was requested
    std::shared_ptr<Job> m_job; ///< being computed
    Map m_map;
    Coarse m_coarse; ///< null: not known, or the chunks are there
    std::optional<Error> m_failure;
    bool m_isUnreported = false; ///< m_failure was not reported
    bool m_news = false; ///< not yet returned by collect()
    std::map<Ticket, std::shared_ptr<Job>> m_asked;
    TaskThread m_thread; ///< last, since it uses all of the above
};

} // namespace core

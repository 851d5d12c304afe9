// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/TaskThread.h"
#include "core/delta/BrickDelta.h"
#include "core/history/History.h"
#include "core/session/state/RowDifferences.h"
#include "core/session/surface/SurfaceStep.h"
#include "core/sessionfile/SessionFile.h"
#include "core/sessionfile/records/StateHash.h"

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace core {

using Changes = std::shared_ptr<const std::vector<BrickChange>>;

/// What has to be done after an edit while the user continues: the compressed difference, the state
/// hash, and the second half of the row on disk. It has one thread and works in the order of the
/// calls, which come from the session's thread.
class CommitWorker {
public:
    /// The result of one of the calls.
    struct Report {
        RowId row = 0;
        std::size_t deltaBytes = 0; ///< after commit()
        QByteArray stateHash; ///< after commit()
        std::optional<Result<RowDifferences>> differences; ///< after load()
        /// it failed; then the following hashes cannot be computed either
        std::optional<Error> error;
    };

    /// @param grid of the volume
    /// @param file where differences are written; null: they stay in memory, compressed
    /// @param wakeUp called on the worker's thread when collect() has something
    CommitWorker(const BrickGrid& grid, SessionFile* file, std::function<void()> wakeUp);

    /// Sets the voxels with which the session begins.
    void start(std::vector<BrickImage> bricks);
    void commit(RowId row, Changes changes, QByteArray documentJson);
    /// For a row that changed the surface and no voxel.
    void commit(RowId row, std::shared_ptr<const SurfaceStep> step, QByteArray documentJson);
    /// For undo and redo, which change bricks without a new row.
    void move(Changes changes);
    /// Requests the difference of a committed row.
    /// @param words also report where seed words differ, which means reading all of them
    void load(RowId row, bool words = false);

    [[nodiscard]] std::vector<Report> collect();
    void finish() { m_thread.finish(); }
    /// Blocks.
    [[nodiscard]] QByteArray stateHash(const QByteArray& documentJson);

private:
    void post(std::function<void()> work);
    void attempt(const std::function<void()>& work);
    void complete(RowId row, const QByteArray& documentJson, BrickDelta delta);
    void report(Report report);
    [[nodiscard]] Result<RowDifferences> differencesOf(RowId row, bool words);
    [[nodiscard]] Result<std::vector<BrickImage>> imagesOf(RowId row);

    BrickGrid m_grid;
    SessionFile* m_file = nullptr;
    std::function<void()> m_wakeUp;
    std::mutex m_mutex;
    std::vector<Report> m_reports; ///< under m_mutex

    // The worker's thread only:
    StateHash m_hash;
    bool m_failed = false; ///< m_hash is wrong
    std::map<RowId, BrickDelta> m_deltas;

    TaskThread m_thread; ///< last, since it uses all of the above
};

} // namespace core

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

/// What follows an edit while the user goes on: the compressed difference, the state hash, the
/// second half of the row on disk. One thread, in the order of the calls; the session's thread
/// calls.
class CommitWorker {
public:
    /// Something that was asked for is there.
    struct Report {
        RowId row = 0;
        std::size_t deltaBytes = 0; ///< after commit()
        QByteArray stateHash; ///< after commit()
        std::optional<Result<RowDifferences>> differences; ///< after load()
        std::optional<Error> error; ///< it cannot be had; the hashes that follow cannot, either
    };

    /// @param grid of the volume
    /// @param file where differences go; null: they stay in memory, compressed
    /// @param wakeUp called on the worker's thread when collect() has something
    CommitWorker(const BrickGrid& grid, SessionFile* file, std::function<void()> wakeUp);

    /// The voxels that the session begins with.
    void start(std::vector<BrickImage> bricks);
    void commit(RowId row, Changes changes, QByteArray documentJson);
    /// Of a row that changed the surface and no voxel.
    void commit(RowId row, std::shared_ptr<const SurfaceStep> step, QByteArray documentJson);
    /// Undo or redo happened.
    void move(Changes changes);
    /// Asks for the difference of a row that was committed. @param words also where seed words
    /// differ, which costs a look at all of them
    void load(RowId row, bool words = false);

    [[nodiscard]] std::vector<Report> collect();
    void finish() { m_thread.finish(); }
    /// Waits.
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
    bool m_failed = false; ///< m_hash is not what it should be
    std::map<RowId, BrickDelta> m_deltas;

    TaskThread m_thread; ///< last: it uses all of the above
};

} // namespace core

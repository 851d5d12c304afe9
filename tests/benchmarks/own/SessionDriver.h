// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/session/EditSession.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

namespace bench {

/// A session the way the window drives it: calls that return at once, polled when something wakes
/// it up. Every call is timed on the thread that makes it.
class SessionDriver {
public:
    static std::unique_ptr<SessionDriver> create(
        core::EditEngine& engine, const core::LoadedVolume& volume, const QString& file);
    static std::unique_ptr<SessionDriver> open(
        core::EditEngine& engine, const core::LoadedVolume& volume, const QString& file);

    struct Commit {
        double wallMs = 0.0; ///< from the first call until the voxels are in place
        std::vector<double> callsMs; ///< end(), apply(), undo() …, and each poll()
        [[nodiscard]] double longestCallMs() const;
    };
    Commit apply(const core::Edit& edit);
    /// Under the pen: sample by sample; only what comes from pen-up on is timed.
    Commit stroke(const core::Edit& stroke);

    // Until the voxels are in place.
    Commit undo();
    Commit redo();
    Commit goTo(core::RowId row);

    /// Whether steps are kept in memory, so that undo and redo read no file.
    void keepSteps(bool kept);

    void settle(); ///< all is on disk
    [[nodiscard]] QByteArray hash(); ///< settles
    [[nodiscard]] const core::History& history() const { return m_session->history(); }
    [[nodiscard]] core::RowId lastRow() const { return core::RowId(history().rows().size()); }
    /// Every voxel of a field of bytes, x fastest.
    [[nodiscard]] std::vector<std::uint8_t> dense(core::Field field, std::uint8_t plane);
    /// What went wrong so far; empty: nothing.
    [[nodiscard]] QString problem() const { return m_problem; }

private:
    explicit SessionDriver(core::EditEngine& engine)
        : m_engine(engine)
    {
    }
    template <typename Call> Commit timed(Call&& call);
    void waitUntilIdle(Commit& commit);
    void note(const core::Result<void>& result);

    core::EditEngine& m_engine;
    std::mutex m_guard;
    std::condition_variable m_changed;
    bool m_woken = false;
    QString m_problem;
    std::unique_ptr<core::EditSession> m_session; ///< last: it wakes us
};

/// What a row takes in a closed session file: its text, its hashes and its difference.
[[nodiscard]] qint64 bytesInFile(const QString& file, core::RowId row);

/// Memory of this process that is in use (Linux).
[[nodiscard]] qint64 residentBytes();

} // namespace bench

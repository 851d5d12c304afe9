// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/session/EditSession.h"
#include "core/session/past/LabelReader.h"
#include "ui/tasks/ExportJob.h"

#include <QObject>

#include <memory>
#include <set>
#include <vector>

namespace ui {

/// Reads label planes, or the coverage of sculpt layers, from the engine, a portion at a time while
/// the window goes on, in the state after everything that was requested of the session. GUI thread;
/// never waits.
class LabelFetch : public QObject {
    Q_OBJECT

public:
    /// Shared by all who keep them, since a plane takes a byte per voxel of the volume.
    using Planes = std::shared_ptr<const std::vector<ExportJob::Plane>>;

    using QObject::QObject;

    /// Starts reading; closes a running growth first.
    /// @param session lives until the fetch has ended or was cancelled
    void start(core::EditSession& session, const std::set<std::uint8_t>& planes,
        core::Field field = core::Field::Labels);
    /// Stops; nothing is reported any more.
    void cancel()
    {
        m_assembling.cancel();
        m_work.reset();
        m_failures = 0;
    }
    [[nodiscard]] bool running() const { return m_work != nullptr; }
    /// Whether it makes sense to start again after this failure: true if the study was edited
    /// meanwhile. After mostFailures failures in a row without an edit the reason is another one,
    /// so the answer is false.
    [[nodiscard]] bool mayTryAgain(const core::Error& error) const;
    /// Failures in a row without an edit in between, after which mayTryAgain() is false.
    static constexpr int mostFailures = 5;

Q_SIGNALS:
    void progressed(int done, int total);
    void finished(const ui::LabelFetch::Planes& planes);
    void failed(const core::Error& error);

private:
    struct Work {
        core::EditSession& session;
        std::shared_ptr<const void> reading; ///< until all portions are there
        std::vector<std::shared_ptr<core::LabelReader>> readers; ///< one per plane, in turn
        std::size_t current = 0;
        std::optional<core::RowId> position{}; ///< of the history, at the first answer
    };
    void askNext();
    void take(const core::Result<void>& portion);
    void fail(const core::Error& error);

    std::shared_ptr<Work> m_work;
    int m_failures = 0; ///< in a row, at the same position of the history
    core::RowId m_failedAt{};
    core::Background m_assembling; ///< last: its results are delivered to all of the above
};

} // namespace ui

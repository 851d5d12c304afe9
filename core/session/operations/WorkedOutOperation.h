// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/kinds/Edit.h"
#include "core/sculpt/labels/LayerWrites.h"
#include "core/session/operations/Relabelling.h"
#include "core/session/state/Operation.h"
#include "core/session/surface/SideThread.h"

#include <atomic>
#include <memory>
#include <variant>

namespace core {

/// An operation that works out on the side thread, from voxels that it has read, what an edit of a
/// segment relabels, and then lets the engine write that: one row if it changed anything.
class WorkedOutOperation : public AbortableOperation {
public:
    /// What is to be written; one segment receives voxels, or several do.
    using Listed = std::variant<RelabelListed, LabelListed>;

    [[nodiscard]] bool done() const final { return m_relabelling.done(); }
    void abort() final;
    [[nodiscard]] bool isAbortable() const final { return !m_isWriting && !done(); }
    [[nodiscard]] int percent() const final { return m_watch->percent; }

protected:
    /// What the side thread shares with the session's.
    struct Watch {
        Watch();
        std::atomic<int> percent = -1; ///< of what the progress is told, if it is told anything
        Progress progress;
    };

    /// @param again as in VoxelOperation
    explicit WorkedOutOperation(RowId again);

    /// What waited in line may meet another document than the one it was checked against.
    /// @return false: it has given up
    [[nodiscard]] bool mayStart(SessionState& state, const Edit& edit);
    /// Whether it was not aborted. @return false: it has given up
    [[nodiscard]] bool mayGoOn(SessionState& state);
    /// Gives up if the work throws.
    void workAside(SessionState& state, SideThread::Work work);
    /// The last step: the engine writes, unless nothing could be worked out or it was aborted.
    void write(SessionState& state, const Edit& edit, Result<Listed>&& listed);
    void leaveNoRow(SessionState& state) { m_relabelling.leaveNoRow(state); }
    void giveUp(SessionState& state, const Error& error) { m_relabelling.giveUp(state, error); }
    /// An answer that is none to what the operation has read.
    void takeWritten(SessionState& state, EngineResult&& result);

    [[nodiscard]] const std::shared_ptr<Watch>& watch() const { return m_watch; }

private:
    std::shared_ptr<Watch> m_watch;
    bool m_isWriting = false;
    Relabelling m_relabelling;
};

} // namespace core

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

/// An operation that reads voxels, computes on the side thread what an edit of a segment relabels,
/// and then lets the engine write it: one row if it changed anything.
class WorkedOutOperation : public AbortableOperation {
public:
    /// What is to be written: RelabelListed if one segment gains or loses voxels, LabelListed if
    /// several receive some, MapLabels if the engine itself finds them.
    using Listed = std::variant<RelabelListed, LabelListed, MapLabels>;

    [[nodiscard]] bool done() const final { return m_relabelling.done(); }
    void abort() final;
    [[nodiscard]] bool isAbortable() const final { return !m_isWriting && !done(); }
    [[nodiscard]] int percent() const final { return m_watch->percent; }

protected:
    /// What the side thread shares with the session's.
    struct Watch {
        Watch();
        std::atomic<int> percent = -1; ///< as reported by `progress`; −1: nothing was reported yet
        Progress progress;
    };

    /// @param again as in VoxelOperation
    explicit WorkedOutOperation(RowId again);

    /// Checks the edit again, because the document may have changed while the operation waited in
    /// the queue.
    /// @return false: the edit is refused, and the operation has given up
    [[nodiscard]] bool mayStart(SessionState& state, const Edit& edit);
    /// Checks whether the operation was aborted.
    /// @return false: it was, and it has given up
    [[nodiscard]] bool mayGoOn(SessionState& state);
    /// Runs work on the side thread. If it throws, the operation gives up.
    void workAside(SessionState& state, SideThread::Work work);
    /// The last step: lets the engine write, unless the computation failed or the operation was
    /// aborted.
    void write(SessionState& state, const Edit& edit, Result<Listed>&& listed);
    void leaveNoRow(SessionState& state) { m_relabelling.leaveNoRow(state); }
    void giveUp(SessionState& state, const Error& error) { m_relabelling.giveUp(state, error); }
    /// Takes a result that does not answer one of the operation's own questions.
    void takeWritten(SessionState& state, EngineResult&& result);

    [[nodiscard]] const std::shared_ptr<Watch>& watch() const { return m_watch; }

private:
    std::shared_ptr<Watch> m_watch;
    bool m_isWriting = false;
    Relabelling m_relabelling;
};

} // namespace core

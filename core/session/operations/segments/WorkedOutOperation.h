// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/sculpt/labels/LayerWrites.h"
#include "core/session/operations/segments/Relabelling.h"
#include "core/session/state/Operation.h"
#include "core/session/surface/SideTask.h"

#include <memory>
#include <optional>
#include <variant>

namespace core {

/// An operation that reads voxels, computes on the side thread what an edit of a segment relabels,
/// and then lets the engine write it: one row if it changed anything.
///
/// An interactive one is a preview: it is computed and written all the same, and stands open until
/// it is ended. Committed before it is written, it goes on as a whole one; rolled back before that,
/// it stops computing.
class WorkedOutOperation : public OpenOperation, public AbortableWork {
public:
    enum class Kind {
        Whole, ///< it ends by itself
        Interactive, ///< it stands open until end()
    };
    /// What is to be written: RelabelListed if one segment gains or loses voxels, LabelListed if
    /// several receive some, LabelPlanes if they do so in several planes, MapLabels if the engine
    /// itself finds them.
    using Listed = std::variant<RelabelListed, LabelListed, LabelPlanes, MapLabels>;

    [[nodiscard]] bool done() const final { return m_relabelling.done(); }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) final;

    void abort(SessionState& state) final;
    /// Until the engine begins to write.
    [[nodiscard]] bool isAbortable() const final;
    [[nodiscard]] int percent(const SessionState&) const final { return m_watch->percent; }

    /// What was aborted no longer stands open, although its computation may not have noticed yet.
    [[nodiscard]] bool open() const final
    {
        return !m_ending && !done() && !m_watch->progress.cancelled();
    }
    /// It takes no further input.
    void extend(SessionState&, const StrokeExtension&) final { }
    void end(SessionState& state, Ending ending) final;
    [[nodiscard]] const Edit& edit() const final { return m_edit; }
    [[nodiscard]] OpenManner manner() const final { return m_manner; }
    [[nodiscard]] bool hasBegun() const final { return m_isWriting; }

protected:
    using Watch = SideWatch;

    /// @param again as in VoxelOperation
    WorkedOutOperation(Edit edit, Kind kind, RowId again);

    /// Checks the edit again, because the document may have changed while the operation waited in
    /// the queue.
    /// @return false: the edit is refused, and the operation has given up
    [[nodiscard]] bool mayStart(SessionState& state);
    /// Checks whether the operation was aborted or rolled back.
    /// @return false: it was, and it has given up
    [[nodiscard]] bool mayGoOn(SessionState& state);
    /// Runs work on the side thread. If it throws, the operation gives up.
    void workAside(SessionState& state, SideThread::Work work);
    /// Replaces the edit, which the computation may have completed.
    void complete(Edit edit) { m_edit = std::move(edit); }
    /// The last step: lets the engine write, unless the computation failed or the operation was
    /// aborted.
    void write(SessionState& state, Result<Listed>&& listed);
    /// There is nothing to write.
    void leaveAsItIs(SessionState& state);
    void giveUp(SessionState& state, const Error& error);
    /// Takes a result that does not answer one of the operation's own questions.
    void takeWritten(SessionState& state, EngineResult&& result);

    [[nodiscard]] const std::shared_ptr<Watch>& watch() const { return m_watch; }
    /// Whether it becomes a row if it changes anything; a preview does not unless it is committed.
    [[nodiscard]] bool isCommitted() const { return m_ending == Ending::Commit; }
    [[nodiscard]] bool isRolledBack() const { return m_ending == Ending::Rollback; }

private:
    Edit m_edit;
    OpenManner m_manner;
    std::optional<Ending> m_ending; ///< none: it stands open
    std::shared_ptr<Watch> m_watch;
    SideTask m_aside;
    bool m_isWriting = false; ///< the result was given to the engine, or there was nothing to write
    Relabelling m_relabelling;
};

} // namespace core

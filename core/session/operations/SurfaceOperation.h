// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/SurfaceEdit.h"
#include "core/session/past/LabelReading.h"
#include "core/session/state/Operation.h"
#include "core/session/surface/SurfaceWork.h"

#include <memory>
#include <optional>

namespace core {

/// An edit of the surface that is refined: its mesh is deformed on the side thread, from which the
/// display is updated too; one row. Laying a surface, following the mask and writing back read the
/// labels from the engine first. Writing back and setting barriers are one engine transaction as
/// well.
class SurfaceOperation final : public OpenOperation {
public:
    enum class Kind {
        Whole, ///< the edit is complete
        Interactive, ///< the user continues it until end()
    };
    /// @param again as in VoxelOperation
    template <isSurfaceKind E>
    SurfaceOperation(const E& edit, Kind kind, RowId again = 0)
        : SurfaceOperation(Edit(edit), kind, again)
    {
    }

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool done() const override { return m_done; }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;
    [[nodiscard]] bool foresee(Document& document) const override;

    /// For an edit that is abortable: it ends with Cancelled and changes nothing. One that stands
    /// open must be rolled back afterwards.
    void abort();
    /// Laying a surface, following the mask, and a preview until it can be seen.
    [[nodiscard]] bool isAbortable() const;

    [[nodiscard]] bool open() const override { return m_kind == Kind::Interactive && !m_ending; }
    [[nodiscard]] const Edit& edit() const override { return m_edit; }
    [[nodiscard]] OpenManner manner() const override { return m_manner; }
    [[nodiscard]] bool hasBegun() const override { return m_hasBegun; }
    [[nodiscard]] bool refused() const override { return m_reported; }
    /// By points of its path.
    void extend(SessionState& state, const StrokeExtension& extension) override;
    void end(SessionState& state, Ending ending) override;

private:
    SurfaceOperation(Edit edit, Kind kind, RowId again);
    void readOn(SessionState& state);
    void work(SessionState& state);
    void finish(SessionState& state, Result<SurfaceWork::Outcome>&& outcome);
    void write(SessionState& state, EngineEdit&& edit);
    /// @param failed why nothing is to come of it; none: it may become a row
    void endWork(SessionState& state, Ending ending, const std::optional<Error>& failed = {});
    void post(SessionState& state, std::function<SideThread::Sequel()> work);
    void giveUp(SessionState& state, const Error& error);
    [[nodiscard]] bool isTakenBack(const Error& error) const;
    void reportFailure(SessionState& state, const Error& error);

    Edit m_edit;
    OpenManner m_manner;
    Kind m_kind;
    RowId m_again = 0;
    std::optional<LabelReading> m_reading; ///< while labels are being read
    std::optional<Ticket> m_asked; ///< question for codes
    SurfaceWork::Read m_read;
    std::shared_ptr<SurfaceWork> m_work; ///< from when it continues on the side thread
    std::optional<Ending> m_ending;
    std::optional<Ticket> m_begun; ///< the transaction that writes voxels
    std::optional<Ticket> m_written; ///< the end of the transaction that writes voxels
    bool m_isEnding = false; ///< the request to end was passed to the side thread
    bool m_isAbandoned = false; ///< what the side thread makes of it is taken back
    bool m_isAborted = false;
    bool m_hasBegun = false; ///< SurfaceWork::begin() is through; a preview can be seen
    bool m_reported = false; ///< the reason for the failure was reported
    bool m_done = false;
};

/// Sets another listener for what must be drawn of the surface. It takes its turn in the queue,
/// when nothing deforms the surface.
class ShowSurface final : public Operation {
public:
    explicit ShowSurface(SurfaceState::Listener listener);
    void start(SessionState& state) override;
    [[nodiscard]] bool done() const override { return m_done; }
    [[nodiscard]] bool foreseePosition(const History&, ForeseenPosition&) const override
    {
        return true;
    }

private:
    SurfaceState::Listener m_listener;
    bool m_done = false;
};

} // namespace core

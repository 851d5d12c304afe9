// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/open/OpenStroke.h"
#include "core/engine/EngineEdit.h"
#include "core/session/past/SketchedSeeds.h"
#include "core/session/state/Operation.h"

#include <deque>
#include <memory>
#include <vector>

namespace core {

/// An edit of voxels, which may also change the document: one engine transaction, and one row if it
/// changed anything. One that takes long (mayTakeLong()) can be aborted when it is to become a row.
class VoxelOperation final : public OpenOperation, public AbortableWork {
public:
    enum class Kind {
        Whole, ///< the edit is complete
        Interactive, ///< the user continues it until end()
    };
    /// @param again a row that is carried out again when a session is opened; 0: a new row
    VoxelOperation(Edit edit, Kind kind, RowId again = 0);

    // For interactive operations only:
    void extend(SessionState& state, const StrokeExtension& extension) override;
    void end(SessionState& state, Ending ending) override;
    [[nodiscard]] bool open() const override { return m_kind == Kind::Interactive && !m_ending; }
    [[nodiscard]] const Edit& edit() const override { return m_edit; }
    /// The engine never opened it, or something has failed.
    [[nodiscard]] bool refused() const override { return m_refused || m_failed; }
    [[nodiscard]] OpenManner manner() const override { return m_manner; }
    [[nodiscard]] bool hasBegun() const override { return m_begun.has_value(); }

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool done() const override { return m_finished || (m_refused && m_ending); }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;
    [[nodiscard]] bool foresee(Document& document) const override;

    void abort(SessionState& state) override;
    /// True from the moment it is to become a row until the engine's answer was taken in.
    [[nodiscard]] bool isAbortable() const override;
    [[nodiscard]] int percent(const SessionState& state) const override;
    /// A session that ends waits for it: what the engine has begun is soon done.
    [[nodiscard]] bool isAwaitedAtEnd() const override { return true; }

private:
    [[nodiscard]] bool isWhole() const { return m_kind == Kind::Whole; }
    void askBefore(SessionState& state, const EngineEdit& edit);
    void takeBefore(const EngineResult& result);
    void keepNothing(const SessionState& state);
    void liftPen();
    void submitWaiting(SessionState& state);
    void finish(SessionState& state, EngineResult&& result);

    Edit m_edit;
    Kind m_kind;
    RowId m_again = 0;
    std::unique_ptr<OpenStroke> m_stroke; ///< of m_edit; null: it cannot stand open
    OpenManner m_manner;
    std::deque<EngineExtension> m_waiting;
    std::optional<Ending> m_ending;
    std::optional<Ticket> m_asked; ///< for the state of voxels where seeds are sketched
    SeedPlacement m_seeds; ///< until the answer arrives
    std::optional<SketchedSeeds> m_sketched;
    std::optional<Ticket> m_begun;
    std::optional<Ticket> m_ended;
    bool m_mayTakeLong = false; ///< the engine, once it has begun
    bool m_refused = false; ///< the engine never opened it
    bool m_failed = false; ///< something failed, so nothing of it may remain
    bool m_finished = false;
};

} // namespace core

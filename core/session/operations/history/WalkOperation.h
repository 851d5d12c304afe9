// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/state/Operation.h"

namespace core {

/// Undo, redo, or a walk to any row. It goes row by row and applies each row's difference to the
/// bricks; if the bricks of a row are still in memory, it puts those in place instead.
class WalkOperation final : public Operation {
public:
    enum class Aim { Undo, Redo, Row };
    explicit WalkOperation(Aim aim, RowId target = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    void takeDifferences(SessionState& state, Result<RowDifferences>&& differences) override;
    [[nodiscard]] RowId awaitedRow() const override { return m_isLoading ? m_row : 0; }
    [[nodiscard]] bool done() const override { return m_done; }
    [[nodiscard]] bool foresee(Document&) const override { return m_done; }
    [[nodiscard]] bool foreseePosition(
        const History& history, ForeseenPosition& position) const override;
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;

private:
    /// Chooses the next row and the direction. @return false: the target is reached
    [[nodiscard]] bool choose(const History& history);
    void step(SessionState& state);
    void put(SessionState& state, EngineCommand command);
    void arrive(SessionState& state, EngineResult&& result);
    void giveUp(SessionState& state, const Error& error);

    Aim m_aim;
    RowId m_target = 0;
    RowId m_row = 0; ///< whose difference is being applied
    bool m_back = false; ///< whether it is being undone
    bool m_isLoading = false; ///< its difference is being loaded for this operation
    bool m_isAbandoned = false; ///< abandoned; ends when the difference has arrived
    std::optional<Ticket> m_swapping; ///< the engine is changing bricks
    bool m_arriving = false; ///< the bricks are in place, but the history does not say so yet
    bool m_done = false;
};

} // namespace core

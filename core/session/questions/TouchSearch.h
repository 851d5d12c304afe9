// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/questions/Touch.h"
#include "core/session/state/Operation.h"
#include "core/session/surface/SideTask.h"

#include <functional>
#include <map>

namespace core {

/// Searches for the last step in effect that touched something. Steps that only took others back
/// are skipped, so that undoing the answer and asking again gives the step before it. It goes back
/// from the newest row, one difference at a time, and changes nothing.
class TouchSearch final : public Operation {
public:
    using Answer = std::function<void(RowId)>; ///< 0: none

    TouchSearch(const Touch& touch, Answer answer);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    void takeDifferences(SessionState& state, Result<RowDifferences>&& differences) override;
    [[nodiscard]] RowId awaitedRow() const override { return m_isLoading ? m_rows.back() : 0; }
    [[nodiscard]] bool done() const override { return m_done; }
    [[nodiscard]] bool foreseePosition(const History&, ForeseenPosition&) const override
    {
        return true;
    }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;

private:
    /// What is examined on another thread than the session's.
    struct Looking {
        std::vector<BrickImage> differences; ///< of one row
        std::map<BrickKey, BrickImage> images; ///< as they were after that row
        bool touched = false;

        [[nodiscard]] bool touches(const Touch& touch, const BrickGrid& grid) const;
        /// Goes from the state after the row to the state before it.
        void goBack();
    };
    void loadNext(SessionState& state);
    void look(SessionState& state);
    void goOn(SessionState& state, RowId row, Looking& looked);
    void answer(SessionState& state, RowId row);

    Touch m_touch;
    Answer m_answer;
    std::vector<RowId> m_rows; ///< the last one is examined next
    std::vector<RowId> m_standing; ///< those that can be the answer, ascending
    std::vector<BrickImage> m_differences; ///< of the row that is examined
    std::map<BrickKey, BrickImage> m_images; ///< as they were after that row
    Ticket m_reading = 0;
    SideTask m_aside;
    bool m_isLoading = false; ///< differences are being loaded for this search
    bool m_done = false;
};

} // namespace core

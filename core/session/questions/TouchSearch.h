// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/questions/Touch.h"
#include "core/session/state/Operation.h"

#include <functional>
#include <map>

namespace core {

/// Looks for the last step that stands and touched something. Steps that took others back are
/// passed over, so that whoever undoes what was found, and asks again, is told the one before. From
/// the newest back, one difference at a time; changes nothing.
class TouchSearch final : public Operation {
public:
    using Answer = std::function<void(RowId)>; ///< 0: none

    TouchSearch(const Touch& touch, Answer answer);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    void takeDifferences(SessionState& state, Result<RowDifferences>&& differences) override;
    [[nodiscard]] bool done() const override { return m_done; }

private:
    /// What is looked at beside the session's thread.
    struct Looking {
        std::vector<BrickImage> differences; ///< of a row
        std::map<BrickKey, BrickImage> images; ///< as that row left them
        bool touched = false;

        [[nodiscard]] bool touches(const Touch& touch, const BrickGrid& grid) const;
        /// From what the row left to what it found.
        void goBack();
    };
    void loadNext(SessionState& state);
    void look(SessionState& state);
    void goOn(SessionState& state, RowId row, Looking& looked);
    void answer(SessionState& state, RowId row);

    Touch m_touch;
    Answer m_answer;
    std::vector<RowId> m_rows; ///< the last is looked at next
    std::vector<RowId> m_standing; ///< those that may be the answer, ascending
    std::vector<BrickImage> m_differences; ///< of the row that is looked at
    std::map<BrickKey, BrickImage> m_images; ///< as that row left them
    Ticket m_reading = 0;
    bool m_done = false;
};

} // namespace core

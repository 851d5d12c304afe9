// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/DifferenceSwap.h"
#include "core/session/Operation.h"

#include <map>

namespace core {

/// "Undo only here": lays the differences of older rows over the bricks as they are now, which is a
/// new row. Refused, naming the row, where a later one wrote or read the same place (RowReach).
class RevertOperation final : public Operation {
public:
    /// @param again a row that is carried out again (opening a session); 0: a new one
    explicit RevertOperation(RevertRows edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    void takeDifferences(
        SessionState& state, Result<std::vector<BrickImage>>&& differences) override;
    [[nodiscard]] bool done() const override { return m_done; }

private:
    [[nodiscard]] Result<void> checkRows(const SessionState& state) const;
    [[nodiscard]] Result<void> checkReach(const SessionState& state) const;
    [[nodiscard]] bool isTakenBack(RowId row) const;
    void loadNext(SessionState& state);
    void layOver(SessionState& state);
    void finish(SessionState& state, EngineResult&& result);
    void giveUp(SessionState& state, const Error& error);

    RevertRows m_edit;
    RowId m_again = 0;
    std::vector<RowId> m_path; ///< from the first row that is taken back to the position
    std::vector<RowId> m_toLoad; ///< the last is loaded next
    std::map<RowId, std::vector<BrickImage>> m_differences;
    DifferenceSwap m_swap;
    bool m_done = false;
};

} // namespace core

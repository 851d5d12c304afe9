// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/past/GrowthTrace.h"
#include "core/session/past/ImportTrace.h"
#include "core/session/past/RowDependencies.h"
#include "core/session/state/Operation.h"
#include "core/session/surface/SideTask.h"

#include <map>
#include <memory>

namespace core {

struct RevertRows;

/// "Undo only here": applies the differences of older rows to the present bricks, as a new row. It
/// is refused, naming the row, if a later row wrote or read the same place (RowDependencies). Where
/// imports of masks count among these, the side thread looks where they have voxels; before that is
/// done it can be aborted.
class RevertOperation final : public Operation, public AbortableWork {
public:
    /// @param again a row that is carried out again when a session is opened; 0: a new row
    explicit RevertOperation(const RevertRows& edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    void takeDifferences(SessionState& state, Result<RowDifferences>&& differences) override;
    [[nodiscard]] RowId awaitedRow() const override { return m_isLoading ? m_toLoad.back() : 0; }
    [[nodiscard]] bool done() const override { return m_done; }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;

    void abort(SessionState&) override;
    [[nodiscard]] bool isAbortable() const override;
    [[nodiscard]] int percent(const SessionState&) const override { return m_watch->percent; }
    /// A session that ends waits for it: finding where imports have voxels takes little time, and
    /// the user requested the step.
    [[nodiscard]] bool isAwaitedAtEnd() const override { return true; }

private:
    [[nodiscard]] Result<void> checkRows(const SessionState& state) const;
    [[nodiscard]] Result<void> checkDependencies(const SessionState& state) const;
    [[nodiscard]] bool isTakenBack(RowId row) const;
    /// Whether the whole difference of a row is needed, and not only where it changed seed words.
    [[nodiscard]] bool isNeeded(RowId row, const Edit& edit) const;
    /// The imports whose dependencies checkDependencies() asks for.
    [[nodiscard]] ImportTrace importsAsked(const SessionState& state) const;
    void loadNext(SessionState& state);
    /// Finds where the imports have voxels, then applies the differences.
    void lookAtImports(SessionState& state);
    void checkAndLayOver(SessionState& state);
    /// @return false: it was aborted, and has given up
    [[nodiscard]] bool mayGoOn(SessionState& state);
    [[nodiscard]] RowTrace traceOf(const SessionState& state, RowId row) const;
    void layOver(SessionState& state);
    void finish(SessionState& state, EngineResult&& result);
    void giveUp(SessionState& state, const Error& error);

    std::vector<RowId> m_rows; ///< that are taken back
    RowId m_again = 0;
    std::vector<RowId> m_path; ///< from the first row that is taken back to the position
    std::vector<RowId> m_toLoad; ///< the last one is loaded next
    std::map<RowId, std::vector<BrickImage>> m_differences;
    GrowthTrace m_growth;
    ImportTrace m_imports;
    std::shared_ptr<SideWatch> m_watch = std::make_shared<SideWatch>();
    SideTask m_aside; ///< finds where the imports have voxels
    bool m_isLoading = false; ///< differences are being loaded for this operation
    std::optional<Ticket> m_swapping;
    bool m_done = false;
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/history/StandingStrokes.h"
#include "core/session/operations/history/StrokeFold.h"
#include "core/session/state/Operation.h"
#include "core/session/surface/SideTask.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace core {

/// Changes or removes an earlier stroke: computes the bricks that its old and its new cut touch
/// again, as a new row. In each brick, the cuts of all strokes in effect are combined in the order
/// of the history (carving takes the deeper cut, restoring what it leaves), starting from what was
/// there before the first of them. Voxels are only looked at on the side thread.
///
/// It is refused, naming the row, if something other than a stroke has written to the layer since,
/// such as a segment that was carved into it or a merged layer: the cuts alone would not give the
/// present content. It is also refused if it would carve a segment that is protected now.
///
/// Every stroke keeps the surface on which it started and the segments that were protected then:
/// those of the state before its row, whatever became of earlier strokes since. Later strokes that
/// would now meet another surface are reported (SessionState::lastRevision).
class ReviseOperation final : public Operation {
public:
    /// @param again a row that is carried out again when a session is opened; 0: a new row
    explicit ReviseOperation(ReviseStroke edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    void takeDifferences(SessionState& state, Result<RowDifferences>&& differences) override;
    [[nodiscard]] RowId awaitedRow() const override { return m_isLoading ? m_toLoad.back() : 0; }
    [[nodiscard]] bool done() const override { return m_done; }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;

private:
    using Then = std::function<void(SessionState&, EngineResult&&)>;
    using Sequel = SideThread::Sequel;

    [[nodiscard]] Result<void> findStrokes(const SessionState& state);
    /// @param first the row before which the content is taken as the base for the cuts
    [[nodiscard]] Result<void> checkLayers(const SessionState& state, RowId first) const;
    void loadNext(SessionState& state);
    void await(Ticket ticket, Then then);
    /// Has the fold worked on aside, then continues with what the work returns.
    void workAside(SessionState& state, std::function<Sequel(StrokeFold&)> work);
    /// Goes to the state before a row of the path.
    void goBefore(SessionState& state, RowId row, Sequel then);
    void cut(SessionState& state, const StandingStroke& stroke,
        std::function<void(SessionState&, StrokeCut)> then);
    void cutTarget(SessionState& state);
    void compareTarget(SessionState& state);
    /// @param isMoved whether the stroke cuts otherwise now
    void chooseBricks(SessionState& state, bool isMoved);
    void beginFold(SessionState& state);
    void foldNext(SessionState& state);
    /// Combines a cut with those before it, then continues with foldNext().
    /// @param anew what the stroke would cut now; if it is another cut, that is reported
    void lay(SessionState& state, const StandingStroke& stroke, StrokeCut recorded,
        std::optional<StrokeCut> anew = {});
    /// Checks whether a stroke would now start on another surface, then continues with lay().
    void compare(SessionState& state, const StandingStroke& stroke, StrokeCut recorded);
    void put(SessionState& state);
    void putFolded(SessionState& state);
    void finish(SessionState& state, EngineResult&& result);
    /// @pre no cut is under way
    void giveUp(SessionState& state, const Error& error);
    void report(SessionState& state, const Error& error);
    /// Returns to the position once everything that was asked before abandon() is answered.
    void takeBack(SessionState& state, const EngineResult& result);

    ReviseStroke m_edit;
    RowId m_again = 0;
    StandingStroke m_before; ///< the stroke itself
    StandingStroke m_after;
    std::vector<StandingStroke> m_strokes; ///< to combine, once the bricks are known
    std::size_t m_next = 0; ///< index into m_strokes
    std::vector<RowId> m_path; ///< from the first of them to the position
    std::vector<RowId> m_toLoad; ///< the last one is loaded next
    std::shared_ptr<StrokeFold> m_fold; ///< from when the strokes are known
    bool m_isLoading = false; ///< differences are being loaded for this operation
    SideTask m_aside; ///< which has the fold
    bool m_isPut = false; ///< the engine has what was folded
    std::vector<RowId> m_begunInside;
    Ticket m_awaited = 0;
    std::optional<Ticket> m_first; ///< that it has awaited
    std::optional<Error> m_refused; ///< why something before the awaited result failed
    Then m_then;
    bool m_isReported = false; ///< why it failed
    bool m_isAbandoned = false;
    bool m_done = false;
};

} // namespace core

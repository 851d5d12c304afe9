// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/history/StandingStrokes.h"
#include "core/session/questions/PastCoverage.h"
#include "core/session/state/Operation.h"

#include <deque>
#include <functional>
#include <map>
#include <set>

namespace core {

/// Changes or removes a stroke out of order: evaluates the bricks that its old and its new cut
/// touch again, which is a new row. Per brick, the cuts of all strokes that stand are folded in the
/// order of the history (carving: the deeper cut wins; restoring: what it leaves), on what was
/// there before the first of them.
///
/// Refused, naming the row, where something that is no stroke has written the layer since: a
/// segment that was carved into it, a merger. Cuts alone would not make up what stands there.
///
/// Every stroke keeps the surface it started on, and the voxels of segments that it spared: those
/// of the row before it, whatever has become of earlier strokes since. Later strokes that would
/// have met another surface are told (SessionState::lastRevision). Refused where it would carve a
/// segment that is protected now.
class ReviseOperation final : public Operation {
public:
    /// @param again a row that is carried out again (opening a session); 0: a new one
    explicit ReviseOperation(ReviseStroke edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    void takeDifferences(SessionState& state, Result<RowDifferences>&& differences) override;
    [[nodiscard]] bool done() const override { return m_done; }

private:
    using Then = std::function<void(SessionState&, EngineResult&&)>;

    [[nodiscard]] Result<void> findStrokes(const SessionState& state);
    /// @param first the row before which the ground is that cuts are laid on
    [[nodiscard]] Result<void> checkLayers(const SessionState& state, RowId first) const;
    void loadNext(SessionState& state);
    void await(Ticket ticket, Then then);
    void cut(SessionState& state, const StandingStroke& stroke,
        std::function<void(SessionState&, StrokeCut)> then);
    void cutTarget(SessionState& state);
    void chooseBricks(SessionState& state);
    void beginFold(SessionState& state);
    void foldNext(SessionState& state);
    void lay(const StrokeCut& cut, const StandingStroke& stroke);
    /// Whether a stroke would start on another surface now; goes on with foldNext().
    void compare(SessionState& state, const StandingStroke& stroke, StrokeCut recorded);
    void put(SessionState& state);
    void putFolded(SessionState& state);
    void finish(SessionState& state, EngineResult&& result);
    void giveUp(SessionState& state, const Error& error);

    ReviseStroke m_edit;
    RowId m_again = 0;
    StandingStroke m_before; ///< the stroke itself
    StandingStroke m_after;
    StrokeCut m_cutBefore;
    StrokeCut m_cutAfter;
    std::vector<StandingStroke> m_strokes; ///< to fold, once the bricks are known
    std::size_t m_next = 0; ///< of them
    std::vector<RowId> m_path; ///< from the first of them to the position
    std::vector<RowId> m_toLoad; ///< the last is loaded next
    PastCoverage m_past{std::vector<RowId>(), false};
    std::map<BrickKey, BrickImage> m_folded; ///< the bricks that are evaluated again
    std::vector<RowId> m_begunInside;
    Ticket m_awaited = 0;
    std::optional<Error> m_refused; ///< why something before the awaited one was
    Then m_then;
    bool m_done = false;
};

} // namespace core

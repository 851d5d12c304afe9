// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/Ending.h"
#include "core/edits/kinds/Edit.h"
#include "core/session/state/SessionState.h"

#include <optional>

namespace core {

struct LabelListed;
struct LabelPlanes;
struct MapLabels;
struct RelabelListed;

/// The last part of operations that have computed for each voxel how to relabel it: one engine
/// transaction, and one row if it changed anything. The operation that contains it is done when
/// this is.
class Relabelling {
public:
    /// @param again as in VoxelOperation
    explicit Relabelling(RowId again);

    /// Lets the engine write, and leaves that open until end(). If the engine refuses, it has
    /// ended.
    /// @param edit the edit that the row will contain
    /// @param relabel without bricks nothing is written
    void begin(SessionState& state, Edit edit, RelabelListed&& relabel);
    void begin(SessionState& state, Edit edit, LabelListed&& label);
    void begin(SessionState& state, Edit edit, LabelPlanes&& planes);
    void begin(SessionState& state, Edit edit, const MapLabels& map);
    /// Ends what was begun. Without a row if nothing was.
    void end(SessionState& state, Ending ending);
    /// Both at once, to be committed.
    void write(SessionState& state, Edit edit, RelabelListed&& relabel);
    /// Ends without a row, because nothing has changed.
    void leaveNoRow(SessionState& state);
    void giveUp(SessionState& state, const Error& error);
    /// Ends without a row, after something has failed that was reported.
    void drop() { m_done = true; }
    /// As Operation::abandon(), for as long as it is not ended.
    [[nodiscard]] bool abandon(SessionState& state, const Error& error);
    void takeResult(SessionState& state, EngineResult&& result);

    [[nodiscard]] bool done() const { return m_done; }
    /// Whether a row is carried out again. The rows after it build on it, so that it must not be
    /// left out.
    [[nodiscard]] bool isAgain() const { return m_again != 0; }

private:
    template <class Listed> void submit(SessionState& state, Edit&& edit, Listed&& listed);
    void finish(SessionState& state, EngineResult&& result);

    RowId m_again;
    Edit m_edit;
    std::optional<Ticket> m_begun; ///< none: nothing is written
    std::optional<Ticket> m_ended;
    bool m_failed = false; ///< whether it failed and the error was reported
    bool m_done = false;
};

} // namespace core

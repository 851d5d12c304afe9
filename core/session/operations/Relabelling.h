// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/session/state/SessionState.h"

#include <optional>

namespace core {

struct LabelListed;
struct RelabelListed;

/// How operations end that work out voxel by voxel what to relabel: one engine transaction, and one
/// row if it changed anything. Part of such an operation, which is done when this is.
class Relabelling {
public:
    /// @param again as in VoxelOperation
    explicit Relabelling(RowId again);

    /// Lets the engine write.
    /// @param edit what its row says
    /// @param relabel without bricks there is nothing to be done
    void write(SessionState& state, Edit edit, RelabelListed&& relabel);
    void write(SessionState& state, Edit edit, LabelListed&& label);
    /// Ends without having written.
    void leaveNoRow(SessionState& state);
    void giveUp(SessionState& state, const Error& error);
    void takeResult(SessionState& state, EngineResult&& result);

    [[nodiscard]] bool done() const { return m_done; }

private:
    template <class Listed> void begin(SessionState& state, Edit&& edit, Listed&& listed);
    void finish(SessionState& state, EngineResult&& result);

    RowId m_again;
    Edit m_edit;
    std::optional<Ticket> m_begun;
    std::optional<Ticket> m_ended;
    bool m_failed = false; ///< which has been told
    bool m_done = false;
};

} // namespace core

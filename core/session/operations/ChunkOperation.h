// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/ChunkVoxels.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/session/operations/segments/Relabelling.h"
#include "core/session/past/LabelReading.h"
#include "core/session/state/Operation.h"
#include "core/session/surface/SideTask.h"

namespace core {

/// Divides a segment and its surroundings into chunks: one row, which records the labels on which
/// the division is based. They are read here if the edit does not contain them yet. The chunks
/// themselves are computed when they are needed (ChunkWorker). Repeating the same division leaves
/// no row.
class DivideOperation final : public Operation {
public:
    /// @param again as in VoxelOperation
    explicit DivideOperation(DivideSegment edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool done() const override { return m_done; }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;
    [[nodiscard]] bool foresee(Document& document) const override;

private:
    void readNext(SessionState& state);
    void takeOwners(SessionState& state, Result<std::vector<ChunkOwner>>&& owners);
    void commit(SessionState& state);
    void giveUp(SessionState& state, const Error& error);

    DivideSegment m_edit;
    RowId m_again = 0;
    std::optional<LabelReading> m_reading; ///< until all is read
    SideTask m_aside;
    bool m_done = false;
};

/// Adds or removes chunks of the newest division that the user clicked: one engine transaction, and
/// one row if it changed anything. It waits for the chunks if they are not available.
class ToggleChunks final : public Operation {
public:
    explicit ToggleChunks(ChunkToggle edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeChunks(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool awaitsChunks() const override { return m_awaited.has_value(); }
    [[nodiscard]] bool done() const override { return m_relabelling.done(); }
    [[nodiscard]] bool abandon(SessionState& state, const Error& error) override;

private:
    void click(SessionState& state, const ChunkMap& map);
    void relabel(SessionState& state, std::vector<BrickChange> labels);

    ChunkToggle m_edit;
    ChunkClick m_click;
    std::optional<RowId> m_awaited; ///< the division whose chunks are not available yet
    std::optional<ClickedChunks> m_clicked;
    std::optional<Ticket> m_asked; ///< for what their bricks hold
    SideTask m_aside;
    Relabelling m_relabelling;
};

} // namespace core

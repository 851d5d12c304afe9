// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/session/operations/Relabelling.h"
#include "core/session/past/LabelReader.h"
#include "core/session/state/Operation.h"

#include <optional>

namespace core {

/// Fills holes of a segment, removes islands from it or gives one away: it reads the labels of the
/// segment's plane, works out on the side thread which voxels are meant, and lets the engine write
/// them; one row if it changed anything.
class IslandOperation final : public Operation {
public:
    /// @param again as in VoxelOperation
    explicit IslandOperation(const CleanSegment& edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    [[nodiscard]] bool done() const override { return m_relabelling.done(); }

private:
    void readNext(SessionState& state);
    void write(SessionState& state, Result<RelabelListed>&& relabel);

    CleanSegment m_edit;
    std::optional<LabelReader> m_reader;
    std::optional<Ticket> m_asked; ///< for labels
    Relabelling m_relabelling;
};

} // namespace core

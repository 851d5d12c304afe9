// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/operations/WorkedOutOperation.h"
#include "core/session/past/LabelReader.h"

#include <functional>
#include <optional>
#include <span>

namespace core {

/// An edit of a segment as a whole that is worked out from all labels of its plane (CleanSegment,
/// ReshapeSegment, FillBetweenSlices, MirrorSegment, SplitIslands, SplitSegment).
class IslandOperation final : public WorkedOutOperation {
public:
    /// @param again as in VoxelOperation
    explicit IslandOperation(const CleanSegment& edit, RowId again = 0);
    explicit IslandOperation(const ReshapeSegment& edit, RowId again = 0);
    explicit IslandOperation(const FillBetweenSlices& edit, RowId again = 0);
    explicit IslandOperation(const MirrorSegment& edit, RowId again = 0);
    explicit IslandOperation(const SplitIslands& edit, RowId again = 0);
    explicit IslandOperation(const SplitSegment& edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    /// How many segments are made of islands is known when they have been counted.
    [[nodiscard]] bool foresee(Document& document) const override;

private:
    /// @param edit may be completed by what is found
    using LabelWork = std::function<Result<Listed>(const Document& document,
        std::span<const std::uint8_t> labels, const Progress& progress, Edit& edit)>;

    IslandOperation(Edit edit, int segment, LabelWork workOut, RowId again);
    void readNext(SessionState& state);

    Edit m_edit;
    int m_segment; ///< label
    LabelWork m_workOut;
    std::optional<LabelReader> m_reader;
    std::optional<Ticket> m_asked; ///< for labels
};

} // namespace core

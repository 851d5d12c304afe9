// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/operations/segments/WorkedOutOperation.h"
#include "core/session/past/LabelReading.h"

#include <functional>
#include <optional>
#include <span>

namespace core {

/// Carries out an edit of a whole segment that is computed from all labels of its plane
/// (CleanSegment, ReshapeSegment, FillBetweenSlices, MirrorSegment, SplitSegment, SplitByCurve).
class IslandOperation final : public WorkedOutOperation {
public:
    /// @param again as in VoxelOperation
    explicit IslandOperation(const CleanSegment& edit, Kind kind = Kind::Whole, RowId again = 0);
    explicit IslandOperation(const ReshapeSegment& edit, Kind kind = Kind::Whole, RowId again = 0);
    explicit IslandOperation(
        const FillBetweenSlices& edit, Kind kind = Kind::Whole, RowId again = 0);
    explicit IslandOperation(const MirrorSegment& edit, Kind kind = Kind::Whole, RowId again = 0);
    explicit IslandOperation(const SplitSegment& edit, Kind kind = Kind::Whole, RowId again = 0);
    explicit IslandOperation(const SplitByCurve& edit, Kind kind = Kind::Whole, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    /// As Operation::foresee(). A preview changes nothing before it is committed.
    [[nodiscard]] bool foresee(Document& document) const override;

private:
    /// Computes what to write.
    using LabelWork = std::function<Result<Listed>(
        const Document& document, std::span<const std::uint8_t> labels, const Progress& progress)>;

    IslandOperation(Edit edit, int segment, LabelWork workOut, Kind kind, RowId again);
    void readNext(SessionState& state);

    int m_segment; ///< label
    LabelWork m_workOut;
    std::optional<LabelReading> m_reading; ///< until all is read
};

} // namespace core

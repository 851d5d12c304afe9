// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/operations/segments/WorkedOutOperation.h"
#include "core/session/past/LabelReading.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace core {

struct LabelPlane;

/// Carries out an edit of a whole segment that is computed from all labels of its plane
/// (CleanSegment, ReshapeSegment, FillBetweenSlices, MirrorSegment, SplitSegment, SplitByCurve), or
/// of several segments, from those of all their planes.
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
    /// Computes what to write. The planes are ascending.
    using LabelWork = std::function<Result<Listed>(
        const Document& document, std::span<const LabelPlane> planes, const Progress& progress)>;

    IslandOperation(
        Edit edit, std::vector<int> segments, LabelWork workOut, Kind kind, RowId again);
    template <class E> [[nodiscard]] static LabelWork relabelling(const E& edit);
    void readNext(SessionState& state);

    std::vector<int> m_segments; ///< labels
    LabelWork m_workOut;
    std::vector<LabelReading> m_readings; ///< of their planes, until all is read
    std::size_t m_reading = 0; ///< which of these
};

} // namespace core

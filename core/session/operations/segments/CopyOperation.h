// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/session/operations/segments/WorkedOutOperation.h"
#include "core/session/past/LabelReading.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace core {

/// Carries out a CopySegment. If it names no label plane, the planes with segments are read one
/// after the other, until one is found in which all voxels of the segment are free; no voxel is
/// read if there is only the segment's own. Then the engine writes.
class CopyOperation final : public WorkedOutOperation {
public:
    /// @param again as in VoxelOperation
    explicit CopyOperation(CopySegment edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;
    /// As Operation::foresee(). Returns false as long as the edit names no plane; the copy, with
    /// its label, is in the document all the same.
    [[nodiscard]] bool foresee(Document& document) const override;

private:
    /// The labels of the segment's plane, x fastest.
    using Labels = std::shared_ptr<const std::vector<std::uint8_t>>;

    [[nodiscard]] const CopySegment& copy() const { return edit().get<CopySegment>(); }
    void lookAt(SessionState& state, std::uint8_t plane);
    void readNext(SessionState& state);
    void lookFurther(SessionState& state);
    void writeCopy(SessionState& state);

    Labels m_own;
    std::vector<std::uint8_t> m_taken; ///< planes in which others have voxels of the segment
    std::vector<std::uint8_t> m_left; ///< planes that were not looked at, the next one last
    std::optional<LabelReading> m_reading; ///< until all of a plane is read
};

} // namespace core

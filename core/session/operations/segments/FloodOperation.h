// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/islands/BrickFlood.h"
#include "core/sculpt/CapsuleSweep.h"
#include "core/session/operations/segments/WorkedOutOperation.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace core {

/// Carries out a FloodFill. It reads what the region reaches, codes or labels, in blocks: within a
/// slice of the grid, first one of 128² voxels around the place, in which most regions end, then
/// blocks so large that most slices are a single one; elsewhere, blocks of 64³ voxels. The side
/// thread extends the region in them until it is complete; then the engine writes it, as one row.
class FloodOperation final : public WorkedOutOperation {
public:
    /// @param again as in VoxelOperation
    explicit FloodOperation(const FloodFill& edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;

private:
    /// The contents of one block.
    struct Reading {
        VoxelBox box;
        /// Bricks in the block that the flood did not have before.
        std::vector<std::uint32_t> bricks;
        std::vector<std::uint16_t> codes; ///< x fastest; none for labels
        std::vector<BrickImage> labels; ///< those that are not empty
    };
    /// Used by this thread and the side thread, never at the same time.
    struct Work {
        FloodFill edit;
        BrickGrid grid;
        glm::ivec3 first;
        BrickFlood flood;
        std::optional<CapsuleFrame> slice; ///< obliqueSlice()
        VoxelEncoding encoding;
        /// Codes within the tolerance; known from the first block on.
        std::optional<CodeInterval> interval{};
    };
    void askNext(SessionState& state);
    void goOn(SessionState& state);
    [[nodiscard]] std::vector<Reading> nextReadings() const;
    static void give(Work& work, const Reading& reading);

    [[nodiscard]] const FloodFill& fill() const { return edit().get<FloodFill>(); }

    std::shared_ptr<Work> m_work; ///< null before it starts
    bool m_isFirstReading = true;
    std::map<Ticket, Reading> m_asked; ///< questions that are not answered yet
    std::vector<Reading> m_read;
    std::optional<Error> m_failed; ///< error of an answer, while other answers are outstanding
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/islands/BrickFlood.h"
#include "core/session/operations/WorkedOutOperation.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace core {

/// A flood fill. It reads what it reaches, codes or labels, in blocks: in a slice of so many bricks
/// that most slices are one, in all directions of 64³ voxels. The side thread goes on in them until
/// the region ends; then the engine writes it, as one row.
class FloodOperation final : public WorkedOutOperation {
public:
    /// @param again as in VoxelOperation
    explicit FloodOperation(const FloodFill& edit, RowId again = 0);

    void start(SessionState& state) override;
    void takeResult(SessionState& state, EngineResult&& result) override;

private:
    /// What was read of a block.
    struct Reading {
        VoxelBox box;
        std::vector<std::uint32_t> bricks; ///< that it covers and were not given yet
        std::vector<std::uint16_t> codes; ///< x fastest; none for labels
        std::vector<BrickImage> labels; ///< those that are not empty
    };
    /// Shared with the side thread.
    struct Work {
        FloodFill edit;
        BrickGrid grid;
        glm::ivec3 first;
        BrickFlood flood;
        VoxelEncoding encoding;
        std::optional<CodeInterval> interval{}; ///< known with the first block
    };
    void askNext(SessionState& state);
    void goOn(SessionState& state);
    [[nodiscard]] std::vector<Reading> nextReadings() const;
    static void give(Work& work, const Reading& reading);

    FloodFill m_edit;
    std::shared_ptr<Work> m_work; ///< null before it starts
    std::map<Ticket, Reading> m_asked; ///< no answer yet
    std::vector<Reading> m_read;
    std::optional<Error> m_failed; ///< of an answer, while others are outstanding
};

} // namespace core

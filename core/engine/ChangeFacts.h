// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <cstdint>
#include <vector>

namespace core {

/// How many voxels came to a label of a plane, and how many went from it.
struct LabelFlow {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    std::int64_t gained = 0;
    std::int64_t lost = 0;
};

/// What can be said of changed bricks. It is counted on the thread of the engine that made them, so
/// that nobody who waits for a result has to look at their voxels.
struct ChangeFacts {
    int bricksOfAllFields = 0; ///< changed
    int bricks = 0; ///< changed, of coverage and labels
    std::int64_t voxelsChanged = 0; ///< values that differ, of coverage and labels
    std::int64_t seedWordsChanged = 0;

    VoxelBox coverage; ///< what surrounds the bricks of that field that changed; index space
    VoxelBox labels;
    VoxelBox seedWords;

    /// Of labels that gained or lost a voxel, sorted by plane and label. Label 0 is not among them.
    std::vector<LabelFlow> flows;
    /// Voxels whose label changed: those that were emptied or given back to the label that growth
    /// had taken them from (Field::Beneath), and all others.
    std::int64_t labelsLost = 0;
    std::int64_t labelsGrown = 0;

    /// The greatest generation among the members in bricks of seed words that changed.
    std::uint32_t greatestGeneration = 0;
    /// Generations of the members in such bricks that were sketched seeds; ascending, each once.
    std::vector<std::uint32_t> seedGenerations;

    /// Zero where nothing came or went.
    [[nodiscard]] LabelFlow flow(std::uint8_t plane, int label) const;
    [[nodiscard]] bool admittedSeedsAt(std::uint32_t generation) const;
    [[nodiscard]] bool empty() const { return bricksOfAllFields == 0; }
};

/// Cost ∝ the bricks; several threads where there are many.
/// @param grid of the volume
[[nodiscard]] ChangeFacts factsOf(const std::vector<BrickChange>& changes, const BrickGrid& grid);

} // namespace core

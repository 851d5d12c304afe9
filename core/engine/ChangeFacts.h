// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <cstdint>
#include <map>
#include <vector>

namespace core {

/// How many voxels a label of a plane gained and lost.
struct LabelFlow {
    std::uint8_t plane = 0;
    std::uint8_t label = 0;
    std::int64_t gained = 0;
    std::int64_t lost = 0;
};

/// Statistics of changed bricks. They are computed on the engine's thread, so that code that
/// receives a result need not read its voxels.
struct ChangeFacts {
    int bricksOfAllFields = 0; ///< number of changed bricks
    int bricks = 0; ///< of these, bricks of coverage and labels
    std::int64_t voxelsChanged = 0; ///< values that differ, of coverage and labels
    std::int64_t seedWordsChanged = 0;

    VoxelBox coverage; ///< bounding box of the changed bricks of that field, in voxels
    VoxelBox labels;
    VoxelBox seedWords;

    /// The labels that gained or lost voxels, sorted by plane and label; without label 0.
    std::vector<LabelFlow> flows;
    /// Voxels whose label changed: those that became empty or were given back to the label that
    /// growth had overwritten (Field::Overwritten).
    std::int64_t labelsLost = 0;
    /// All other voxels whose label changed.
    std::int64_t labelsGrown = 0;

    /// The greatest generation of the members in the changed bricks of seed words, by plane.
    std::map<std::uint8_t, std::uint32_t> greatestGenerations;
    /// Generations of the members in such bricks that began as seeds; ascending, each once.
    std::vector<std::uint32_t> seedGenerations;

    /// Zeros where the label neither gained nor lost a voxel.
    [[nodiscard]] LabelFlow flow(std::uint8_t plane, int label) const;
    /// 0 where no brick of the plane's seed words changed, or none of those has a member.
    [[nodiscard]] std::uint32_t greatestGeneration(std::uint8_t plane) const;
    [[nodiscard]] bool admittedSeedsAt(std::uint32_t generation) const;
    [[nodiscard]] bool empty() const { return bricksOfAllFields == 0; }
};

/// Computes them. The cost is linear in the bricks; several threads share it if there are many. Any
/// thread.
/// @param grid of the volume
[[nodiscard]] ChangeFacts factsOf(const std::vector<BrickChange>& changes, const BrickGrid& grid);

} // namespace core

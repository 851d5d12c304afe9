// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "core/growth/GrowthCommands.h"

#include <cstdint>
#include <span>
#include <vector>

namespace test {

struct GrownVoxels {
    std::vector<std::uint8_t> mask; ///< label plane 0, x fastest
    std::uint32_t generation = 0;
    double closureMilliseconds = 0.0; ///< until the last voxel was taken
    double milliseconds = 0.0; ///< wall clock from the first command to the last result
};

/// Seeds one segment (label 1, plane 0) and grows it to closure in the volume that the engine
/// holds. It reports no failure to Qt Test: an engine's error gives an empty mask.
[[nodiscard]] GrownVoxels growToClosure(core::EditEngine& engine, const glm::ivec3& size,
    std::span<const glm::ivec3> seeds, int lowCode, int highCode,
    const core::GrowLimits& limits = {});

/// The voxels with codes low … high on the volume's diagonal: many seeds, some of them isolated.
[[nodiscard]] std::vector<glm::ivec3> seedsOnDiagonal(
    const glm::ivec3& size, std::span<const std::uint16_t> codes, int low, int high);

} // namespace test

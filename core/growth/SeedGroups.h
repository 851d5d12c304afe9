// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/SeedStatistics.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// Seeds of a label that have statistics of their own, such as those of one stroke. Voxels count
/// only while they are seeds of the label.
struct SeedGroup {
    std::uint8_t label = 0;
    std::vector<glm::ivec3> voxels{}; ///< inside the volume, ascending by z, y, x, none twice
    bool operator==(const SeedGroup&) const = default;
};

/// Whether no label is 0 and the voxels of each group are in their order.
[[nodiscard]] bool isSound(const std::vector<SeedGroup>& groups);
/// Also whether they lie in the volume. Errors: InvalidField.
[[nodiscard]] Result<void> checkSound(const std::vector<SeedGroup>& groups, const BrickGrid& grid);
/// Whether places lie in the volume. Errors: InvalidField.
[[nodiscard]] Result<void> checkWithin(
    const std::vector<glm::ivec3>& voxels, const BrickGrid& grid);

/// Statistics of the codes around seeds, by group.
struct GroupedSeedSums {
    std::vector<SeedSums> groups{}; ///< in the order of the groups
    std::array<SeedSums, 256> others{}; ///< by label: of its seeds that are in none of its groups
};

} // namespace core

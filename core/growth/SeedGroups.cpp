// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedGroups.h"

#include <algorithm>
#include <tuple>

namespace core {

bool isSound(const std::vector<SeedGroup>& groups)
{
    const auto comesNoLater = [](const glm::ivec3& a, const glm::ivec3& b) {
        return std::tie(a.z, a.y, a.x) >= std::tie(b.z, b.y, b.x);
    };
    return std::all_of(groups.begin(), groups.end(), [&](const SeedGroup& group) {
        const std::vector<glm::ivec3>& voxels = group.voxels;
        return group.label != 0
            && std::adjacent_find(voxels.begin(), voxels.end(), comesNoLater) == voxels.end();
    });
}

Result<void> checkWithin(const std::vector<glm::ivec3>& voxels, const BrickGrid& grid)
{
    for (const glm::ivec3& voxel : voxels) {
        if (glm::any(glm::lessThan(voxel, glm::ivec3(0)))
            || glm::any(glm::greaterThanEqual(voxel, grid.volumeSize)))
            return failure(ErrorCode::InvalidField, QStringLiteral("voxels"),
                Clause::saying("outside the volume"));
    }
    return {};
}

Result<void> checkSound(const std::vector<SeedGroup>& groups, const BrickGrid& grid)
{
    if (!isSound(groups))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("seedGroups"), Clause::saying("are not sound"));
    for (const SeedGroup& group : groups) {
        if (const Result<void> checked = checkWithin(group.voxels, grid); !checked)
            return checked;
    }
    return {};
}

} // namespace core

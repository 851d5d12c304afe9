// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedSpread.h"

#include <algorithm>

namespace core {

bool isSound(const SpreadLabels& spread, const glm::ivec3& volumeSize)
{
    const bool neighbours =
        spread.connectivity == 6 || spread.connectivity == 18 || spread.connectivity == 26;
    const bool lengths = std::all_of(spread.lengths.begin(), spread.lengths.end(),
        [](std::uint32_t length) { return length >= 1 && length <= 65535; });
    const bool within = !spread.box
        || (!spread.box->empty()
            && glm::all(glm::greaterThanEqual(spread.box->minimum, glm::ivec3(0)))
            && glm::all(glm::lessThanEqual(spread.box->maximum, volumeSize)));
    return neighbours && lengths && within && spread.differenceWeight <= 64 && !spread.seeds[0]
        && !spread.overwritable[0] && (spread.seeds & spread.overwritable).none();
}

VoxelBox spreadBox(const SpreadLabels& spread, const VoxelBox& seeds, const glm::ivec3& volumeSize)
{
    if (spread.box)
        return *spread.box;
    const glm::ivec3 extent = seeds.maximum - seeds.minimum;
    const glm::ivec3 margin =
        glm::max((extent + (SpreadLabels::marginParts - 1)) / SpreadLabels::marginParts,
            glm::ivec3(SpreadLabels::leastMargin));
    return {glm::max(seeds.minimum - margin, glm::ivec3(0)),
        glm::min(seeds.maximum + margin, volumeSize)};
}

Result<void> checkSound(const SpreadLabels& spread, const BrickGrid& grid)
{
    if (!isSound(spread, grid.volumeSize))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("spread"), Clause::saying("is not sound"));
    return {};
}

} // namespace core

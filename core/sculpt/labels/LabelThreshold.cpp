// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/LabelThreshold.h"

namespace core {

Result<void> checkSound(const LabelThreshold& edit, const BrickGrid&)
{
    if (edit.target.label == 0)
        return failure(
            ErrorCode::InvalidField, QStringLiteral("label"), Clause::saying("0 is no segment"));
    return checkSound(edit.editable);
}

std::vector<std::uint32_t> bricksMeeting(const VoxelBox& box, const BrickGrid& grid)
{
    const VoxelBox inside{
        glm::max(box.minimum, glm::ivec3(0)), glm::min(box.maximum, grid.volumeSize)};
    if (inside.empty())
        return {};
    const glm::ivec3 first = inside.minimum / BrickGrid::side;
    const glm::ivec3 last = (inside.maximum - 1) / BrickGrid::side;
    const glm::ivec3 bricks = grid.bricks();
    std::vector<std::uint32_t> met;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x)
                met.push_back(std::uint32_t((z * bricks.y + y) * bricks.x + x));
        }
    }
    return met;
}

} // namespace core

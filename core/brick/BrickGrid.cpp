// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickGrid.h"

namespace core {

bool VoxelBox::empty() const
{
    return maximum.x <= minimum.x || maximum.y <= minimum.y || maximum.z <= minimum.z;
}

VoxelBox VoxelBox::united(const VoxelBox& other) const
{
    if (empty())
        return other;
    if (other.empty())
        return *this;
    return {glm::min(minimum, other.minimum), glm::max(maximum, other.maximum)};
}

int BrickGrid::brickCount() const
{
    const glm::ivec3 count = bricks();
    return count.x * count.y * count.z;
}

int BrickGrid::brickOf(const glm::ivec3& voxel) const
{
    const glm::ivec3 count = bricks();
    const glm::ivec3 position = voxel / side;
    return position.x + count.x * (position.y + count.y * position.z);
}

glm::ivec3 BrickGrid::brickPosition(int brick) const
{
    const glm::ivec3 count = bricks();
    return {brick % count.x, brick / count.x % count.y, brick / count.x / count.y};
}

VoxelBox BrickGrid::boxOf(int brick) const
{
    const glm::ivec3 minimum = brickPosition(brick) * side;
    return {minimum, glm::min(minimum + side, volumeSize)};
}

int BrickGrid::offsetInBrick(const glm::ivec3& voxel)
{
    const glm::ivec3 local = voxel % side;
    return local.x + side * (local.y + side * local.z);
}

int bytesPerVoxel(Field field)
{
    return field == Field::SeedWords ? 4 : 1;
}

std::uint8_t emptyByte(Field field)
{
    return field == Field::SeedWords ? 0xFF : 0x00;
}

} // namespace core

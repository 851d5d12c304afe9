// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourState.h"

#include "core/brick/ThreadWithoutVoxels.h"

#include <cstddef>
#include <utility>

namespace core {

ContourState::ContourState(const VoxelBox& box, std::vector<std::uint8_t> voxels)
    : m_box(box)
    , m_voxels(std::move(voxels))
{
    noteVoxelsLookedAt();
    for (const std::uint8_t voxel : m_voxels) {
        if (voxel & ContourGround::held)
            continue;
        const bool isIn = voxel & ContourGround::inside;
        const bool wasIn = voxel & ContourGround::own;
        m_gained += isIn && !wasIn ? 1 : 0;
        m_lost += wasIn && !isIn ? 1 : 0;
    }
}

void ContourState::pass(const std::vector<std::uint32_t>& changed)
{
    noteVoxelsLookedAt();
    for (const std::uint32_t place : changed) {
        const std::uint8_t voxel = m_voxels[place] ^= ContourGround::inside;
        if (voxel & ContourGround::held)
            continue;
        const bool isIn = voxel & ContourGround::inside;
        if (voxel & ContourGround::own)
            m_lost += isIn ? -1 : 1;
        else
            m_gained += isIn ? 1 : -1;
    }
}

void ContourState::pass(std::span<const ContourPlaces> generations)
{
    for (const ContourPlaces& each : generations)
        pass(*each);
}

const std::vector<std::uint8_t>& ContourState::voxels() const
{
    noteVoxelsLookedAt();
    return m_voxels;
}

std::uint8_t ContourState::flagsAt(const glm::ivec3& voxel) const
{
    noteVoxelsLookedAt();
    const glm::ivec3 at = voxel - m_box.minimum;
    const glm::ivec3 extent = m_box.maximum - m_box.minimum;
    if (at.x < 0 || at.y < 0 || at.z < 0 || at.x >= extent.x || at.y >= extent.y
        || at.z >= extent.z)
        return 0;
    return m_voxels[(std::size_t(at.z) * std::size_t(extent.y) + std::size_t(at.y))
            * std::size_t(extent.x)
        + std::size_t(at.x)];
}

bool ContourState::isInside(const glm::ivec3& voxel) const
{
    return isInside(flagsAt(voxel));
}

bool ContourState::wasInside(const glm::ivec3& voxel) const
{
    return flagsAt(voxel) & ContourGround::own;
}

} // namespace core

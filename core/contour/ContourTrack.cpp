// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourTrack.h"

#include <utility>

namespace core {

ContourTrack::ContourTrack(const VoxelBox& box, std::vector<std::uint8_t> voxels)
    : m_box(box)
    , m_voxels(std::move(voxels))
{
    for (const std::uint8_t voxel : m_voxels) {
        if (voxel & ContourGround::held)
            continue;
        const bool isIn = voxel & ContourGround::inside;
        const bool wasIn = voxel & ContourGround::own;
        m_gained += isIn && !wasIn ? 1 : 0;
        m_lost += wasIn && !isIn ? 1 : 0;
    }
}

void ContourTrack::append(std::vector<std::uint32_t> changed)
{
    m_changes.push_back(std::move(changed));
}

void ContourTrack::goTo(int generation)
{
    while (m_shown < generation)
        flip(m_changes[std::size_t(m_shown++)]);
    while (m_shown > generation)
        flip(m_changes[std::size_t(--m_shown)]);
}

void ContourTrack::flip(const std::vector<std::uint32_t>& places)
{
    for (const std::uint32_t place : places) {
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

std::uint8_t ContourTrack::flagsAt(const glm::ivec3& voxel) const
{
    const glm::ivec3 at = voxel - m_box.minimum;
    const glm::ivec3 extent = m_box.maximum - m_box.minimum;
    if (at.x < 0 || at.y < 0 || at.z < 0 || at.x >= extent.x || at.y >= extent.y
        || at.z >= extent.z)
        return 0;
    return m_voxels[(std::size_t(at.z) * std::size_t(extent.y) + std::size_t(at.y))
            * std::size_t(extent.x)
        + std::size_t(at.x)];
}

bool ContourTrack::isInside(const glm::ivec3& voxel) const
{
    return isInside(flagsAt(voxel));
}

bool ContourTrack::wasInside(const glm::ivec3& voxel) const
{
    return flagsAt(voxel) & ContourGround::own;
}

} // namespace core

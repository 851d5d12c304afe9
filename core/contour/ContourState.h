// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/contour/ContourEvolution.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// What a contour came to at one generation, for those who show it: the voxels as they would be
/// written. One that is not changed any more may be read by any number of threads; one that serves
/// a window reads none of its voxels (ThreadWithoutVoxels.h).
class ContourState {
public:
    /// Cost ∝ the box.
    /// @param voxels of the box, x fastest: flags of ContourGround
    ContourState(const VoxelBox& box, std::vector<std::uint8_t> voxels);

    /// Goes a generation further by what that changed, or back by the same. Cost ∝ what changed.
    void pass(const std::vector<std::uint32_t>& changed);
    /// Goes by several.
    void pass(std::span<const ContourPlaces> generations);

    [[nodiscard]] const VoxelBox& box() const { return m_box; }
    [[nodiscard]] std::size_t voxelCount() const { return m_voxels.size(); }
    /// Of the box, x fastest: flags of ContourGround.
    [[nodiscard]] const std::vector<std::uint8_t>& voxels() const;
    /// Whether the segment would have a voxel with these flags.
    [[nodiscard]] static bool isInside(std::uint8_t flags)
    {
        return flags & (flags & ContourGround::held ? ContourGround::own : ContourGround::inside);
    }
    /// Whether the segment would have a voxel; beside the box: no.
    [[nodiscard]] bool isInside(const glm::ivec3& voxel) const;
    /// Whether it had the voxel before there was a contour, or a bubble.
    [[nodiscard]] bool wasInside(const glm::ivec3& voxel) const;
    /// How many voxels it would have gained and lost since then.
    [[nodiscard]] std::int64_t gained() const { return m_gained; }
    [[nodiscard]] std::int64_t lost() const { return m_lost; }

private:
    [[nodiscard]] std::uint8_t flagsAt(const glm::ivec3& voxel) const;

    VoxelBox m_box;
    std::vector<std::uint8_t> m_voxels;
    std::int64_t m_gained = 0;
    std::int64_t m_lost = 0;
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/contour/ContourEvolution.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// A contour at one generation, for display: the voxels as they would be written. Once it is no
/// longer changed, any number of threads may read it. Threads that serve a window must not read its
/// voxels (ThreadWithoutVoxels.h).
class ContourState {
public:
    /// Cost ∝ the box.
    /// @param voxels flags of ContourGround for each voxel of the box, x fastest
    ContourState(const VoxelBox& box, std::vector<std::uint8_t> voxels);

    /// Goes one generation forwards or backwards, given the voxels that differ between the two.
    /// Cost ∝ these.
    void pass(const std::vector<std::uint32_t>& changed);
    /// Goes over several generations (ContourTrack::between()).
    void pass(std::span<const ContourPlaces> generations);

    [[nodiscard]] const VoxelBox& box() const { return m_box; }
    [[nodiscard]] std::size_t voxelCount() const { return m_voxels.size(); }
    /// Flags of ContourGround for each voxel of the box, x fastest.
    [[nodiscard]] const std::vector<std::uint8_t>& voxels() const;
    /// Whether the segment would contain a voxel with these flags if the contour were written.
    [[nodiscard]] static bool isInside(std::uint8_t flags)
    {
        return flags & (flags & ContourGround::held ? ContourGround::own : ContourGround::inside);
    }
    /// The same for a voxel of the volume; false outside the box.
    [[nodiscard]] bool isInside(const glm::ivec3& voxel) const;
    /// Whether the segment contained the voxel before the evolution and before a bubble was added.
    [[nodiscard]] bool wasInside(const glm::ivec3& voxel) const;
    /// How many voxels it would gain and lose compared with that.
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

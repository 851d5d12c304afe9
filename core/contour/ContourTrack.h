// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/contour/ContourEvolution.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// What a contour came to at each generation, for those who watch it: the voxels as they would be
/// written, forwards and backwards. Nothing is evolved here: another thread may do that meanwhile
/// and hand over what each generation changed. Going from one generation to another costs what
/// changed in between. One thread at a time.
class ContourTrack {
public:
    /// At generation 0. Cost ∝ the box.
    /// @param voxels of the box, x fastest: flags of ContourGround
    ContourTrack(const VoxelBox& box, std::vector<std::uint8_t> voxels);

    /// One generation more is known; the one that is shown stays.
    /// @param changed ContourEvolution::lastChanged()
    void append(std::vector<std::uint32_t> changed);
    [[nodiscard]] int known() const { return int(m_changes.size()); }
    /// @pre 0 ≤ generation ≤ known()
    void goTo(int generation);
    [[nodiscard]] int shown() const { return m_shown; }

    [[nodiscard]] const VoxelBox& box() const { return m_box; }
    /// Of the box, x fastest, at the generation that is shown: flags of ContourGround.
    [[nodiscard]] const std::vector<std::uint8_t>& voxels() const { return m_voxels; }
    /// Whether the segment would have a voxel with these flags.
    [[nodiscard]] static bool isInside(std::uint8_t flags)
    {
        return flags & (flags & ContourGround::held ? ContourGround::own : ContourGround::inside);
    }
    /// Whether the segment would have a voxel at the generation that is shown; beside the box: no.
    [[nodiscard]] bool isInside(const glm::ivec3& voxel) const;
    /// Whether it had the voxel before there was a contour, or a bubble.
    [[nodiscard]] bool wasInside(const glm::ivec3& voxel) const;
    /// How many voxels it would have gained and lost since then.
    [[nodiscard]] std::int64_t gained() const { return m_gained; }
    [[nodiscard]] std::int64_t lost() const { return m_lost; }

private:
    [[nodiscard]] std::uint8_t flagsAt(const glm::ivec3& voxel) const;
    void flip(const std::vector<std::uint32_t>& places);

    VoxelBox m_box;
    std::vector<std::uint8_t> m_voxels;
    std::vector<std::vector<std::uint32_t>> m_changes; ///< by generation
    int m_shown = 0;
    std::int64_t m_gained = 0;
    std::int64_t m_lost = 0;
};

} // namespace core

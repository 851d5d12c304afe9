// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// A set of voxels as one bit each within their bounding box: a copy that another thread can read
/// while the segment changes.
class BoxMask {
public:
    BoxMask() = default;
    /// @param labels x fastest
    [[nodiscard]] static BoxMask of(
        std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec3& size);
    [[nodiscard]] static BoxMask of(const VoxelRuns& voxels, const glm::ivec3& size);

    [[nodiscard]] bool empty() const { return m_size.x == 0; }
    [[nodiscard]] const glm::ivec3& first() const { return m_first; }
    [[nodiscard]] const glm::ivec3& size() const { return m_size; }
    /// Whether the voxel is in the set; false outside the box.
    [[nodiscard]] bool contains(const glm::ivec3& voxel) const
    {
        const glm::ivec3 at = voxel - m_first;
        if (glm::any(glm::lessThan(at, glm::ivec3(0)))
            || glm::any(glm::greaterThanEqual(at, m_size)))
            return false;
        const std::size_t bit = bitAt(at);
        return ((m_bits[bit / 64] >> (bit % 64)) & 1U) != 0;
    }
    [[nodiscard]] std::uint64_t voxelCount() const;
    /// Number of faces between a voxel in the set and one that is not, across each axis.
    [[nodiscard]] glm::u64vec3 borderFaces() const;

private:
    BoxMask(const glm::ivec3& least, const glm::ivec3& most);
    [[nodiscard]] std::size_t bitAt(const glm::ivec3& at) const
    {
        return (std::size_t(at.z) * std::size_t(m_size.y) + std::size_t(at.y))
            * std::size_t(m_size.x)
            + std::size_t(at.x);
    }
    void add(const glm::ivec3& voxel)
    {
        const std::size_t bit = bitAt(voxel - m_first);
        m_bits[bit / 64] |= std::uint64_t(1) << (bit % 64);
    }

    glm::ivec3 m_first{0};
    glm::ivec3 m_size{0};
    std::vector<std::uint64_t> m_bits;
};

} // namespace core

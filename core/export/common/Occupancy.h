// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace core {

/// How much of each voxel a segment fills, 0 … 255, if it was made from the coverage of a sculpt
/// layer; without one 0 or 255.
///
/// It is the voxel's coverage if that agrees with the segment: a value of one half and more (128)
/// belongs to the segment, a lower one does not. Where segment and layer were changed since, the
/// segment decides: what was painted later is full, what was erased is empty. So exactly the
/// segment's voxels have 128 and more. A lower value is the rim of what was cut beside it, and
/// counts only where a voxel that touches it (by face, edge or corner) is cut and in the segment:
/// around holes that were drilled later, or erased from the segment, nothing is filled.
class Occupancy {
public:
    /// The spans must outlive it; x fastest.
    /// @param coverage empty: the segment was not made from a layer
    /// @param size of the volume, in voxels
    Occupancy(std::span<const std::uint8_t> labels, std::uint8_t label,
        std::span<const std::uint8_t> coverage, const glm::ivec3& size);

    [[nodiscard]] bool hasCoverage() const { return !m_coverage.empty(); }
    [[nodiscard]] std::uint8_t at(std::size_t voxel) const;

private:
    static constexpr std::uint8_t full = 255;
    static constexpr std::uint8_t half = 128;

    [[nodiscard]] bool isRim(std::size_t voxel) const;

    std::span<const std::uint8_t> m_labels;
    std::span<const std::uint8_t> m_coverage;
    glm::ivec3 m_size;
    std::uint8_t m_label;
};

inline Occupancy::Occupancy(std::span<const std::uint8_t> labels, std::uint8_t label,
    std::span<const std::uint8_t> coverage, const glm::ivec3& size)
    : m_labels(labels)
    , m_coverage(coverage)
    , m_size(size)
    , m_label(label)
{
}

inline std::uint8_t Occupancy::at(std::size_t voxel) const
{
    const bool inside = m_labels[voxel] == m_label;
    if (m_coverage.empty())
        return inside ? full : 0;
    const std::uint8_t covered = m_coverage[voxel];
    if (inside)
        return covered >= half ? covered : full;
    return covered > 0 && covered < half && isRim(voxel) ? covered : 0;
}

/// Whether a voxel that is cut and in the segment touches it.
inline bool Occupancy::isRim(std::size_t voxel) const
{
    const auto columns = std::size_t(m_size.x);
    const auto rows = std::size_t(m_size.y);
    const glm::ivec3 at(voxel % columns, voxel / columns % rows, voxel / (columns * rows));
    const glm::ivec3 first = glm::max(at - 1, glm::ivec3(0));
    const glm::ivec3 last = glm::min(at + 1, m_size - 1);
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const std::size_t other =
                    (std::size_t(z) * rows + std::size_t(y)) * columns + std::size_t(x);
                if (m_labels[other] == m_label && m_coverage[other] >= half)
                    return true;
            }
        }
    }
    return false;
}

} // namespace core

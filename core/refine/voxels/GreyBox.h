// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "core/volume/WorldToIndex.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// How grey values change along a line, in codes; upwards is positive.
struct EdgeProfile {
    double stepMm = 0.0; ///< from one to the next
    /// Odd in number; the middle one is at the place that was looked at. Each over the width of two
    /// voxels, as grey values are linear between them.
    std::vector<double> changes{};

    /// How far from the place, along the line, they change most, by how steep that is and how near;
    /// none: they do not change by a code anywhere.
    [[nodiscard]] std::optional<double> edgeMm() const;
};

/// Grey codes of a box of voxels, linear between their centres: a copy that a thread of its own may
/// read, for tools that look for edges. Beyond the box all is as at its rim.
class GreyBox {
public:
    /// @param geometry of the volume; must outlive it
    /// @param first voxel of the box
    /// @param codes of size.x × size.y × size.z voxels, x fastest
    GreyBox(const VolumeGeometry& geometry, const glm::ivec3& first, const glm::ivec3& size,
        std::vector<std::uint16_t> codes);

    [[nodiscard]] double at(const glm::dvec3& placeLps) const;

    /// How grey values change along a line, from so far before a place to so far behind it.
    [[nodiscard]] EdgeProfile profileAlong(
        const glm::dvec3& placeLps, const glm::dvec3& unitWay, double reachMm) const;

private:
    WorldToIndex m_toIndex;
    glm::ivec3 m_first{0};
    glm::ivec3 m_size{0};
    std::vector<std::uint16_t> m_codes;
    double m_stepMm = 0.0; ///< along lines: half of the narrowest side of a voxel
};

} // namespace core

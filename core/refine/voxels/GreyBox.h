// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "core/volume/WorldToIndex.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// How grey values, in codes, change along a line; positive where they increase.
struct EdgeProfile {
    double stepMm = 0.0; ///< distance between values
    /// An odd number of values; the middle one is at the examined place. Each is measured over the
    /// width of two voxels, since grey values are linear between them.
    std::vector<double> changes{};

    /// The distance from the place, along the line, of the most likely edge, judged by steepness
    /// and nearness; none: nowhere do they change by a code.
    [[nodiscard]] std::optional<double> edgeMm() const;
};

/// Grey codes of a box of voxels, linear between their centres: a copy that another thread can
/// read, for tools that search for edges. Outside the box the values at its border are used.
class GreyBox {
public:
    /// @param geometry of the volume; must outlive it
    /// @param first voxel of the box
    /// @param codes of size.x × size.y × size.z voxels, x fastest
    GreyBox(const VolumeGeometry& geometry, const glm::ivec3& first, const glm::ivec3& size,
        std::vector<std::uint16_t> codes);

    [[nodiscard]] double at(const glm::dvec3& placeLps) const;

    /// Changes along a line, from @p reachMm before a place to @p reachMm behind it.
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

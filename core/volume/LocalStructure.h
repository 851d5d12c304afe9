// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace core {

/// The principal directions of gradients around a place (structure tensor), which tell whether a
/// surface or a tube is there. It decides no voxel.
struct LocalStructure {
    /// LPS, of length 1; the first is the direction in which values change most, the last the one
    /// in which they change least.
    std::array<glm::dvec3, 3> directions{};
    std::array<double, 3> changes{}; ///< mean squares, (codes per mm)², in the same order

    /// Values change in all directions but one, directions[2], as in a vessel. Otherwise most of
    /// the surroundings is a surface, perpendicular to directions[0].
    [[nodiscard]] bool isTube() const;
};

/// @param codes of @p box, x fastest
/// @param radiusMm radius of the surroundings; their middle has the greatest weight
/// None: values do not change there, or the box contains no voxel with all its neighbours.
[[nodiscard]] std::optional<LocalStructure> localStructure(std::span<const std::uint16_t> codes,
    const VoxelBox& box, const VolumeGeometry& geometry, const glm::dvec3& placeLps,
    double radiusMm);

/// The voxels that it reads; clipped to the volume, empty outside it.
[[nodiscard]] VoxelBox localStructureBox(
    const VolumeGeometry& geometry, const glm::dvec3& placeLps, double radiusMm);

} // namespace core

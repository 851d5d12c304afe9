// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/volume/VolumeGeometry.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace core {

/// How values run around a place: the principal directions of their gradients there (structure
/// tensor), for whoever asks what lies there. Decides no voxel.
struct LocalStructure {
    /// LPS, of length 1: first the one along which values change most, last the one along which
    /// they change least.
    std::array<glm::dvec3, 3> directions{};
    std::array<double, 3> changes{}; ///< mean squares, (codes per mm)², in that order

    /// Values change to all sides but along one direction, directions[2], as in a vessel; else most
    /// of it is a surface, which lies across directions[0].
    [[nodiscard]] bool isTube() const;
};

/// @param codes of @p box, x fastest @param radiusMm that counts; the middle counts most
/// None: values do not change there, or the box holds no voxel with all of its neighbours.
[[nodiscard]] std::optional<LocalStructure> localStructure(std::span<const std::uint16_t> codes,
    const VoxelBox& box, const VolumeGeometry& geometry, const glm::dvec3& placeLps,
    double radiusMm);

/// The voxels that it looks at; cut at the volume, empty beyond it.
[[nodiscard]] VoxelBox localStructureBox(
    const VolumeGeometry& geometry, const glm::dvec3& placeLps, double radiusMm);

} // namespace core

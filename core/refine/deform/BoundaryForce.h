// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/ExternalForce.h"
#include "core/refine/voxels/SmoothOccupancy.h"
#include "core/volume/VolumeGeometry.h"
#include "core/volume/WorldToIndex.h"

#include <optional>

namespace core {

/// Pulls yellow vertices to the boundary of a mask: outwards along the normal from inside of it,
/// inwards from outside. The way is walked in steps of a quarter of a voxel along the axis on which
/// it is fastest (after Bresenham), to the first crossing, which is then found between voxels on
/// SmoothOccupancy. Where the surface is bent, vertices are wanted beyond it by as much as the
/// faces between them cut the bend short, so that the surface lies on the boundary in the mean.
class BoundaryForce final : public ExternalForce {
public:
    /// @param geometry of the mask's volume; must outlive it
    /// @param reachVoxels how far it looks, along the axis on which that is fastest: a walk that
    /// misses a thin part should not end at the next
    BoundaryForce(const BoxMask& mask, const VolumeGeometry& geometry, double reachVoxels);

    [[nodiscard]] glm::dvec3 forceMm(const SurfacePoint& point) const override;
    /// How far the boundary is along the normal; none: not within reach.
    [[nodiscard]] std::optional<double> alongNormalMm(
        const glm::dvec3& positionLps, const glm::dvec3& normalLps) const;

private:
    /// The normal; but where it lies along the boundary rather than across it, or a vertex outside
    /// looks inwards, as in a surface that is crumpled around a thin part: the way the mask falls
    /// off. A vertex inside that looks inwards was moved past the middle of such a part, and goes
    /// back through it along its normal.
    [[nodiscard]] glm::dvec3 wayOut(
        const glm::dvec3& positionLps, const glm::dvec3& normalLps) const;

    WorldToIndex m_toIndex;
    SmoothOccupancy m_occupancy;
    double m_reachVoxels;
    glm::dmat3 m_indexPerMm; ///< transposed
    double m_widthMm = 0.0; ///< of the narrowest side of a voxel
};

} // namespace core

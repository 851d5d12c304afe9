// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/ExternalForce.h"
#include "core/refine/voxels/SmoothOccupancy.h"
#include "core/volume/VolumeGeometry.h"
#include "core/volume/WorldToIndex.h"

#include <optional>

namespace core {

/// The force that pulls yellow vertices to the boundary of a mask: outwards along the normal if the
/// vertex is inside the mask, inwards if it is outside. It walks in steps of a quarter of a voxel
/// along the axis on which the normal is steepest (after Bresenham) to the first crossing, and then
/// locates that between voxels on SmoothOccupancy. Where the surface is curved, vertices are placed
/// beyond the boundary by as much as the faces between them cut the curve short, so that on average
/// the surface lies on the boundary.
class BoundaryForce final : public ExternalForce {
public:
    /// @param geometry of the mask's volume; must outlive it
    /// @param reachVoxels how far it searches, in voxels along the steepest axis; limited so that a
    /// search that misses a thin part does not end at the next one
    BoundaryForce(const BoxMask& mask, const VolumeGeometry& geometry, double reachVoxels);

    [[nodiscard]] glm::dvec3 forceMm(const SurfacePoint& point) const override;
    /// Distance to the boundary along the normal; none: not found within the search distance.
    [[nodiscard]] std::optional<double> alongNormalMm(
        const glm::dvec3& positionLps, const glm::dvec3& normalLps) const;

private:
    /// The direction of the search. It is the normal, except where that runs along the boundary
    /// instead of across it, or where a vertex outside looks inwards, as in a surface that is
    /// crumpled around a thin part: then it is the direction in which the mask falls off. A vertex
    /// inside that looks inwards was moved past the middle of such a part; it returns through it
    /// along its normal.
    [[nodiscard]] glm::dvec3 wayOut(
        const glm::dvec3& positionLps, const glm::dvec3& normalLps) const;

    WorldToIndex m_toIndex;
    SmoothOccupancy m_occupancy;
    double m_reachVoxels;
    glm::dmat3 m_indexPerMm; ///< transposed
    double m_widthMm = 0.0; ///< of the narrowest side of a voxel
};

} // namespace core

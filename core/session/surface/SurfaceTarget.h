// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/refine/deform/BoundaryForce.h"

#include <memory>
#include <mutex>

namespace core {

/// The mask that the yellow parts of a surface follow.
class SurfaceTarget {
public:
    SurfaceTarget(VoxelRuns voxels, const VolumeGeometry& geometry, double faceAreaMm2);

    [[nodiscard]] const VoxelRuns& voxels() const { return m_voxels; }
    /// The intended area of a face of the surface.
    [[nodiscard]] double faceAreaMm2() const { return m_faceAreaMm2; }
    /// Computed from the voxels around the boundary when it is first requested. Any thread.
    [[nodiscard]] const BoundaryForce& boundary() const;

private:
    /// The distance within which the first fit searches for the boundary.
    static constexpr double reachVoxels = 4.0;

    VoxelRuns m_voxels;
    VolumeGeometry m_geometry;
    double m_faceAreaMm2 = 0.0;
    mutable std::once_flag m_isMade;
    mutable std::unique_ptr<const BoundaryForce> m_boundary;
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SurfaceTarget.h"

#include <utility>

namespace core {

SurfaceTarget::SurfaceTarget(VoxelRuns voxels, const VolumeGeometry& geometry, double faceAreaMm2)
    : m_voxels(std::move(voxels))
    , m_geometry(geometry)
    , m_faceAreaMm2(faceAreaMm2)
{
}

const BoundaryForce& SurfaceTarget::boundary() const
{
    std::call_once(m_isMade, [this] {
        m_boundary = std::make_unique<const BoundaryForce>(
            BoxMask::of(m_voxels, m_geometry.size), m_geometry, reachVoxels);
    });
    return *m_boundary;
}

} // namespace core

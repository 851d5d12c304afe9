// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/DirtyVoxels.h"

#include <algorithm>

namespace gpu {

namespace {

/// @param plane a slice or a cutting plane, without its borders
/// @param cornerAt of the eight of a box, LPS
/// @param below, above mm along the normal: how far what counts as the plane reaches
template <class Plane, class CornerAt>
bool cutsPlane(const Plane& plane, CornerAt cornerAt, double below = 0.0, double above = 0.0)
{
    const glm::dvec3 normal = glm::cross(plane.rightLps, plane.downLps);
    double lowest = 1e300;
    double highest = -1e300;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 upper(corner & 1, corner & 2, corner & 4);
        const double height = glm::dot(cornerAt(upper) - plane.centreLps, normal);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    return lowest <= above && highest >= below;
}

template <class Plane>
bool cutsVoxels(const Plane& plane, const core::VolumeGeometry& geometry,
    const core::VoxelBox& voxels, double below = 0.0, double above = 0.0)
{
    const auto cornerAt = [&](const glm::bvec3& upper) {
        return geometry.toWorld(glm::dvec3(glm::mix(voxels.minimum - 1, voxels.maximum, upper)));
    };
    return !voxels.empty() && cutsPlane(plane, cornerAt, below, above);
}

/// Whether carving there changes the grey values of a slab.
bool slabLosesVoxels(
    const SliceScene& slice, const core::VolumeGeometry& geometry, const core::VoxelBox& carved)
{
    const SceneSlab& slab = slice.slab;
    const double half = slab.reach * slab.stepMm;
    return slab.mode != SlabMode::Off && slice.carvedAsHole
        && cutsVoxels(slice, geometry, carved, slab.offsetMm - half, slab.offsetMm + half);
}

template <class Plane> bool cutsBox(const Plane& plane, const WorldBox& box)
{
    return cutsPlane(
        plane, [&](const glm::bvec3& upper) { return glm::mix(box.minimum, box.maximum, upper); });
}

} // namespace

bool DirtyVoxels::empty() const
{
    return labels.empty() && radiation.empty() && segmentation.empty() && pieces.empty()
        && barriers.empty() && barrierBricks.empty() && cutPreview.empty();
}

bool showsChange(const Scene& scene, const core::VolumeGeometry& geometry, const DirtyVoxels& dirty)
{
    const core::VoxelBox flat = dirty.labels.united(dirty.radiation)
                                    .united(dirty.barriers)
                                    .united(dirty.cutPreview)
                                    .united(dirty.pieces);
    if (const auto* slice = std::get_if<SliceScene>(&scene))
        return cutsVoxels(*slice, geometry, flat)
            || slabLosesVoxels(*slice, geometry, dirty.radiation);
    const auto& volume = std::get<VolumeScene>(scene);
    return !dirty.radiation.empty() || !dirty.segmentation.empty() || !dirty.barrierBricks.empty()
        || !dirty.cutPreview.empty() || (!dirty.pieces.empty() && !volume.pieces.empty())
        || (volume.plane && volume.plane->opacity > 0.0f
            && cutsVoxels(*volume.plane, geometry, flat));
}

bool wantsCubics(const Scene& scene)
{
    if (const auto* slice = std::get_if<SliceScene>(&scene))
        return slice->interpolation == Interpolation::Cubic && slice->slab.mode == SlabMode::Off;
    const auto& plane = std::get<VolumeScene>(scene).plane;
    return plane && plane->opacity > 0.0f && plane->interpolation == Interpolation::Cubic;
}

bool showsSurface(const Scene& scene, const WorldBox& box)
{
    if (box.empty())
        return false;
    if (const auto* slice = std::get_if<SliceScene>(&scene))
        return slice->contour && cutsBox(*slice, box);
    const auto& volume = std::get<VolumeScene>(scene);
    return (volume.surface && volume.surface->opacity > 0.0f)
        || (volume.plane && volume.plane->contour && cutsBox(*volume.plane, box));
}

} // namespace gpu

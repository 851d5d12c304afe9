// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/SceneReach.h"

#include <algorithm>

namespace gpu {

namespace {

/// @param cornerAt of the eight of a box, LPS
template <class CornerAt> bool cutsPlane(const SliceScene& scene, CornerAt cornerAt)
{
    const glm::dvec3 normal = glm::cross(scene.rightLps, scene.downLps);
    double lowest = 1e300;
    double highest = -1e300;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 upper(corner & 1, corner & 2, corner & 4);
        const double height = glm::dot(cornerAt(upper) - scene.centreLps, normal);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    return lowest <= 0.0 && highest >= 0.0;
}

} // namespace

bool meetsPlane(
    const SliceScene& scene, const core::VolumeGeometry& geometry, const core::VoxelBox& voxels)
{
    return cutsPlane(scene, [&](const glm::bvec3& upper) {
        return geometry.toWorld(glm::dvec3(glm::mix(voxels.minimum - 1, voxels.maximum, upper)));
    });
}

bool showsSurface(const Scene& scene, const WorldBox& box)
{
    if (box.empty())
        return false;
    if (const auto* volume = std::get_if<VolumeScene>(&scene))
        return volume->surface && volume->surface->opacity > 0.0f;
    const auto& slice = std::get<SliceScene>(scene);
    return slice.contour && cutsPlane(slice, [&](const glm::bvec3& upper) {
        return glm::mix(box.minimum, box.maximum, upper);
    });
}

} // namespace gpu

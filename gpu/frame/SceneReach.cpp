// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/SceneReach.h"

#include <algorithm>

namespace gpu {

bool meetsPlane(
    const SliceScene& scene, const core::VolumeGeometry& geometry, const core::VoxelBox& voxels)
{
    const glm::dvec3 normal = glm::cross(scene.rightLps, scene.downLps);
    double lowest = 1e300;
    double highest = -1e300;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 index((corner & 1) ? voxels.maximum.x : voxels.minimum.x - 1,
            (corner & 2) ? voxels.maximum.y : voxels.minimum.y - 1,
            (corner & 4) ? voxels.maximum.z : voxels.minimum.z - 1);
        const double height = glm::dot(geometry.toWorld(index) - scene.centreLps, normal);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    return lowest <= 0.0 && highest >= 0.0;
}

} // namespace gpu

// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/PlaneBricks.h"

#include <limits>
#include <set>

namespace gpu {

std::vector<std::uint32_t> bricksUnder(
    const PlaneAxes& axes, const core::BrickGrid& grid, const std::vector<PlaneBox>& boxes)
{
    const glm::ivec3 bricks = grid.bricks();
    // Plane → index, in doubles with margin: this only picks bricks that kernels then decide on.
    const glm::dmat3 indexToPlane{
        glm::dvec3(axes.perI), glm::dvec3(axes.perJ), glm::dvec3(axes.perK)};
    const glm::dmat3 planeToIndex = glm::inverse(indexToPlane);
    const glm::dvec3 origin(axes.origin);
    const glm::dvec3 halfBrick(core::BrickGrid::side / 2.0);
    glm::dvec3 brickReach(0.0);
    for (int axis = 0; axis < 3; ++axis)
        brickReach += glm::abs(indexToPlane[axis]) * (halfBrick.x + 1.0);

    std::set<std::uint32_t> found;
    for (const PlaneBox& box : boxes) {
        glm::dvec3 low(std::numeric_limits<double>::max());
        glm::dvec3 high(std::numeric_limits<double>::lowest());
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 plane((corner & 1) ? box.maximum.x : box.minimum.x,
                (corner & 2) ? box.maximum.y : box.minimum.y,
                (corner & 4) ? box.maximum.z : box.minimum.z);
            const glm::dvec3 index = planeToIndex * (plane - origin);
            low = glm::min(low, index);
            high = glm::max(high, index);
        }
        const glm::ivec3 first =
            glm::clamp(glm::ivec3(glm::floor((low - 2.0) / 16.0)), glm::ivec3(0), bricks - 1);
        const glm::ivec3 last =
            glm::clamp(glm::ivec3(glm::floor((high + 2.0) / 16.0)), glm::ivec3(0), bricks - 1);
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x) {
                    const glm::dvec3 centre =
                        origin + indexToPlane * (glm::dvec3(x, y, z) * 16.0 + halfBrick);
                    const bool apart =
                        glm::any(glm::lessThan(centre + brickReach, glm::dvec3(box.minimum)))
                        || glm::any(glm::greaterThan(centre - brickReach, glm::dvec3(box.maximum)));
                    if (!apart)
                        found.insert(std::uint32_t(x + bricks.x * (y + bricks.y * z)));
                }
            }
        }
    }
    return {found.begin(), found.end()};
}

} // namespace gpu

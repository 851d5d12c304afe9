// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/refine/ChunkRay.h"

#include "core/volume/ClipRegion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ui {

namespace {

bool isDrawn(const gpu::SceneChunks& chunks, const glm::ivec3& voxel)
{
    const glm::ivec3 size = chunks.cells();
    if (glm::any(glm::lessThan(voxel, chunks.box.minimum))
        || glm::any(glm::greaterThanEqual(voxel, chunks.box.maximum)))
        return false;
    const glm::ivec3 within = (voxel - chunks.box.minimum) / chunks.cell;
    const std::uint16_t leaf =
        (*chunks.leaves)[(std::size_t(within.z) * std::size_t(size.y) + std::size_t(within.y))
                * std::size_t(size.x)
            + std::size_t(within.x)];
    return leaf != 0 && leaf <= chunks.argb.size() && chunks.argb[leaf - 1U] >> 24 != 0;
}

std::optional<glm::ivec3> firstAlong(const gpu::VolumeScene& scene, const glm::dvec3& throughLps,
    const core::VolumeGeometry& geometry)
{
    const gpu::SceneChunks& chunks = *scene.chunks;
    const glm::dvec3 forward = glm::normalize(scene.targetLps - scene.eyeLps);
    const glm::dvec3 origin = geometry.toIndex(throughLps);
    const glm::dvec3 direction = geometry.toIndex(throughLps + forward) - origin; // per mm
    std::vector<core::HalfSpace> inside = core::halfSpaces(scene.clip, geometry);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = 1.0;
        inside.push_back({.normal = normal, .offset = chunks.box.maximum[axis] - 0.5});
        inside.push_back({.normal = -normal, .offset = 0.5 - chunks.box.minimum[axis]});
    }
    const auto stretch = core::stretchInside({.from = -1e6, .to = 1e6}, origin, direction, inside);
    if (!stretch)
        return std::nullopt;
    // From voxel to voxel.
    double t = stretch->from;
    glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::round(origin + (t + 1e-6) * direction)),
        chunks.box.minimum, chunks.box.maximum - 1);
    while (t < stretch->to) {
        if (isDrawn(chunks, voxel))
            return voxel;
        int next = 0;
        double least = std::numeric_limits<double>::max();
        for (int axis = 0; axis < 3; ++axis) {
            if (direction[axis] == 0.0)
                continue;
            const double border = voxel[axis] + (direction[axis] > 0.0 ? 0.5 : -0.5);
            const double leaving = (border - origin[axis]) / direction[axis];
            if (leaving < least) {
                least = leaving;
                next = axis;
            }
        }
        t = std::max(t, least);
        voxel[next] += direction[next] > 0.0 ? 1 : -1;
        if (voxel[next] < chunks.box.minimum[next] || voxel[next] >= chunks.box.maximum[next])
            break;
    }
    return std::nullopt;
}

} // namespace

std::optional<glm::ivec3> chunkVoxelUnder(
    const ViewContext& view, const QPointF& pixel, const core::VolumeGeometry& geometry)
{
    const glm::dvec3 lps = view.toLps(pixel);
    if (const auto* slice = std::get_if<gpu::SliceScene>(&view.scene)) {
        const glm::ivec3 voxel(glm::round(geometry.toIndex(lps)));
        return slice->chunks && isDrawn(*slice->chunks, voxel) ? std::optional(voxel)
                                                               : std::nullopt;
    }
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    return scene.chunks ? firstAlong(scene, lps, geometry) : std::nullopt;
}

} // namespace ui

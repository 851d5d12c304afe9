// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/view/ClipHandles.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ui {

namespace {

constexpr int boxFaces = 6;
constexpr double leastPixelsPerMm = 0.25; ///< of what the view shows of a millimetre across

/// A place on a face, and the direction it goes; in a slice a place that lies in it.
std::optional<ClipHandle> handleAt(const ViewContext& view, int face, const glm::dvec3& placeLps,
    const glm::dvec3& outwardLps, const glm::dvec3& normalLps)
{
    glm::dvec3 place = placeLps;
    if (const auto* slice = std::get_if<gpu::SliceScene>(&view.scene)) {
        const glm::dvec3 sliceNormal = glm::cross(slice->rightLps, slice->downLps);
        place -= glm::dot(place - slice->centreLps, sliceNormal) * sliceNormal;
        // Back to the face within the slice.
        const glm::dvec3 within = normalLps - glm::dot(normalLps, sliceNormal) * sliceNormal;
        const double steepness = glm::dot(within, normalLps);
        if (steepness < 0.05)
            return std::nullopt;
        place -= within * (glm::dot(place - placeLps, normalLps) / steepness);
    }
    ClipHandle handle;
    handle.face = face;
    handle.pixel = view.toPixel(place);
    handle.pixelsPerMm = view.toPixel(place + outwardLps) - handle.pixel;
    const double across = 1.0 / view.mmPerPixel();
    if (std::hypot(handle.pixelsPerMm.x(), handle.pixelsPerMm.y()) < leastPixelsPerMm * across)
        return std::nullopt;
    return handle;
}

} // namespace

std::vector<ClipHandle> clipHandles(
    const ViewContext& view, const core::ClipRegion& clip, const core::VolumeGeometry& geometry)
{
    std::vector<ClipHandle> handles;
    const glm::dmat3 direction = geometry.direction();
    const glm::dmat3 gradients = glm::transpose(glm::dmat3(geometry.worldToIndex()));
    const glm::dvec3 middle = 0.5 * (clip.box.minimum + clip.box.maximum);
    for (int face = 0; face < boxFaces; ++face) {
        const int axis = face / 2;
        const double sense = face % 2 == 1 ? 1.0 : -1.0;
        glm::dvec3 place = middle;
        place[axis] = face % 2 == 1 ? clip.box.maximum[axis] : clip.box.minimum[axis];
        if (const auto handle = handleAt(view, face, geometry.toWorld(place),
                sense * direction[axis], glm::normalize(sense * gradients[axis])))
            handles.push_back(*handle);
    }
    for (std::size_t i = 0; i < clip.planes.size(); ++i) {
        const core::ClipPlane& plane = clip.planes[i];
        if (!plane.on)
            continue;
        const glm::dvec3 centre = geometry.toWorld(0.5 * glm::dvec3(geometry.size - 1));
        const glm::dvec3 place =
            centre - glm::dot(centre - plane.pointLps, plane.normalLps) * plane.normalLps;
        if (const auto handle =
                handleAt(view, boxFaces + int(i), place, plane.normalLps, plane.normalLps))
            handles.push_back(*handle);
    }
    return handles;
}

core::ClipRegion movedClip(
    core::ClipRegion clip, int face, double mm, const core::VolumeGeometry& geometry)
{
    if (face >= boxFaces) {
        core::ClipPlane& plane = clip.planes[std::size_t(face - boxFaces)];
        plane.pointLps += mm * plane.normalLps;
        return clip;
    }
    const int axis = face / 2;
    const double steps = mm / geometry.spacingMm()[axis];
    double& low = clip.box.minimum[axis];
    double& high = clip.box.maximum[axis];
    if (face % 2 == 1)
        high = std::min(std::max(high + steps, low + 1.0), geometry.size[axis] - 0.5);
    else
        low = std::max(std::min(low - steps, high - 1.0), -0.5);
    clip.box.on = true;
    return clip;
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "core/volume/ClipRegion.h"

#include <algorithm>
#include <cmath>

namespace core {

bool ClipRegion::any() const
{
    return box.on || std::any_of(planes.begin(), planes.end(), [](const ClipPlane& plane) {
        return plane.on;
    });
}

ClipRegion wholeVolume(const VolumeGeometry& geometry)
{
    ClipRegion region;
    region.box.maximum = glm::dvec3(geometry.size) - 0.5;
    return region;
}

std::vector<HalfSpace> halfSpaces(const ClipRegion& region, const VolumeGeometry& geometry)
{
    std::vector<HalfSpace> result;
    for (int axis = 0; axis < 3 && region.box.on; ++axis) {
        glm::dvec3 outward(0.0);
        outward[axis] = 1.0;
        result.push_back({outward, region.box.maximum[axis]});
        result.push_back({-outward, -region.box.minimum[axis]});
    }
    const glm::dmat3 directions(geometry.indexToWorld);
    for (const ClipPlane& plane : region.planes) {
        if (plane.on)
            result.push_back({glm::transpose(directions) * plane.normalLps,
                glm::dot(plane.normalLps, plane.pointLps - geometry.originLps())});
    }
    return result;
}

std::optional<LineStretch> stretchInside(LineStretch stretch, const glm::dvec3& origin,
    const glm::dvec3& direction, const std::vector<HalfSpace>& halfSpaces)
{
    for (const HalfSpace& half : halfSpaces) {
        const double room = half.offset - glm::dot(half.normal, origin);
        const double approach = glm::dot(half.normal, direction);
        if (std::abs(approach) < 1e-12) {
            if (room < 0.0)
                return std::nullopt;
        } else if (approach > 0.0) {
            stretch.to = std::min(stretch.to, room / approach);
        } else {
            stretch.from = std::max(stretch.from, room / approach);
        }
    }
    if (stretch.from > stretch.to)
        return std::nullopt;
    return stretch;
}

std::vector<glm::dvec3> boxSection(const ClipRegion::Box& box, const VolumeGeometry& geometry,
    const glm::dvec3& pointLps, const glm::dvec3& normalLps)
{
    std::vector<glm::dvec3> corners;
    for (int axis = 0; axis < 3; ++axis) {
        const int other = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        for (int edge = 0; edge < 4; ++edge) {
            glm::dvec3 from = box.minimum;
            from[other] = (edge & 1) ? box.maximum[other] : box.minimum[other];
            from[third] = (edge & 2) ? box.maximum[third] : box.minimum[third];
            glm::dvec3 to = from;
            to[axis] = box.maximum[axis];
            const glm::dvec3 a = geometry.toWorld(from);
            const glm::dvec3 b = geometry.toWorld(to);
            const double above = glm::dot(a - pointLps, normalLps);
            const double below = glm::dot(b - pointLps, normalLps);
            if ((above < 0.0) != (below < 0.0))
                corners.push_back(a + (b - a) * (above / (above - below)));
        }
    }
    if (corners.size() < 3)
        return {};
    // Around their middle, by angle.
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& corner : corners)
        middle += corner / double(corners.size());
    const glm::dvec3 right = glm::normalize(corners.front() - middle);
    const glm::dvec3 up = glm::cross(normalLps, right);
    const auto angle = [&](const glm::dvec3& corner) {
        return std::atan2(glm::dot(corner - middle, up), glm::dot(corner - middle, right));
    };
    std::sort(corners.begin(), corners.end(),
        [&](const glm::dvec3& a, const glm::dvec3& b) { return angle(a) < angle(b); });
    return corners;
}

} // namespace core

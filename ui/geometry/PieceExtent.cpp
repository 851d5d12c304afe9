// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/PieceExtent.h"

#include <algorithm>
#include <optional>

namespace ui {

namespace {

constexpr double lidDegrees = 105.0;

} // namespace

PieceExtent extentOf(
    const std::vector<core::BrickImage>& bricks, const core::VolumeGeometry& geometry, int segment)
{
    constexpr int side = core::BrickGrid::side;
    const core::BrickGrid grid{geometry.size};
    PieceExtent extent;
    std::optional<glm::dvec3> first;
    glm::dvec3 low(1e300);
    glm::dvec3 high(-1e300);
    for (const core::BrickImage& brick : bricks) {
        const glm::ivec3 origin = grid.brickPosition(int(brick.key.brick)) * side;
        const std::vector<std::uint8_t>& values = brick.bytes.read();
        for (std::size_t i = 0; i < values.size(); ++i) {
            const int value = values[i];
            if (segment > 0 ? value != segment : value < 128)
                continue;
            const glm::ivec3 local(int(i) % side, int(i) / side % side, int(i) / (side * side));
            const glm::dvec3 at = geometry.toWorld(glm::dvec3(origin + local));
            low = glm::min(low, at);
            high = glm::max(high, at);
            first = first.value_or(at);
            if ((local.x + local.y + local.z) % 3 == 0)
                extent.pointsLps.push_back(at);
        }
    }
    // Every third voxel of very few may be none.
    if (first && extent.pointsLps.empty())
        extent.pointsLps.push_back(*first);
    if (first) {
        extent.middleLps = (low + high) / 2.0;
        extent.sizeLps = high - low;
    }
    return extent;
}

core::PiecePose lidPose(const core::Piece& lid, const PieceExtent& extent,
    const core::VolumeGeometry& geometry, const glm::dvec3& upLps)
{
    const glm::dvec3 middleLps = geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0);
    glm::dvec3 outward = extent.middleLps - middleLps;
    if (glm::length(outward) < 1.0)
        outward = glm::dvec3(0, 0, 1);
    outward = glm::normalize(outward);
    glm::dvec3 towardsHinge = upLps - glm::dot(upLps, outward) * outward;
    if (glm::length(towardsHinge) < 0.1) // it faces up: the hinge is behind
        towardsHinge = glm::dvec3(0, 1, 0) - outward.y * outward;
    towardsHinge = glm::normalize(towardsHinge);
    // The rim there, and of the rim what lies deepest.
    double farthest = -1e300;
    for (const glm::dvec3& point : extent.pointsLps)
        farthest = std::max(farthest, glm::dot(point, towardsHinge));
    glm::dvec3 hinge(0.0);
    double count = 0.0;
    double deepest = 1e300;
    for (const glm::dvec3& point : extent.pointsLps) {
        if (glm::dot(point, towardsHinge) < farthest - 4.0)
            continue;
        hinge += point;
        count += 1.0;
        deepest = std::min(deepest, glm::dot(point, outward));
    }
    hinge /= count;
    hinge += (deepest - glm::dot(hinge, outward)) * outward;
    core::PiecePose pose;
    pose.rotationDegrees = lidDegrees * glm::cross(outward, towardsHinge);
    const glm::dvec3 pivot = core::pivotOf(lid, geometry);
    pose.offsetMm = hinge + core::rotationMatrix(pose.rotationDegrees) * (pivot - hinge) - pivot;
    return pose;
}

} // namespace ui

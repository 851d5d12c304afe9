// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/CapsuleSweep.h"

#include "core/sculpt/CutFrame.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

double distanceToLine(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& along)
{
    const double squared = glm::dot(along, along);
    const double t =
        squared > 0.0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, from + t * along);
}

/// Whether a box of this half size on its way along a line passes beside a place, seen along one
/// of its axes.
bool passesBeside(const glm::dvec3& away, const glm::dvec3& along, const glm::dvec3& halfSize)
{
    for (int axis = 0; axis < 3; ++axis) {
        const int a = (axis + 1) % 3;
        const int b = (axis + 2) % 3;
        if (std::abs(away[a] * along[b] - away[b] * along[a])
            > halfSize[a] * std::abs(along[b]) + halfSize[b] * std::abs(along[a]))
            return true;
    }
    return false;
}

} // namespace

bool isSound(const CapsuleFrame& frame)
{
    return frame.rampHalfWidth >= 1 && frame.radius >= 0 && frame.halfThickness >= 0
        && frame.shift >= 0 && frame.shift < 16 && frame.reach >= 0
        && frame.reach < (1 << 14) << frame.shift && frame.radius <= frame.reach;
}

glm::ivec3 strokeBase(const CapsuleFrame& frame, const glm::ivec3& firstVoxel)
{
    glm::ivec3 base;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = std::size_t(axis);
        base[axis] = int(fixedPoint::round14(frame.origin[i] + firstVoxel.x * frame.perI[i]
            + firstVoxel.y * frame.perJ[i] + firstVoxel.z * frame.perK[i]));
    }
    return base;
}

glm::ivec3 strokeStep(const Fixed3& perVoxel)
{
    return fixedPoint::round14(perVoxel);
}

bool isInSlab(const CapsuleFrame& frame, const glm::ivec3& voxel)
{
    if (!frame.isFlat)
        return true;
    const glm::ivec3 first = voxel / BrickGrid::side * BrickGrid::side;
    const glm::ivec3 local = voxel - first;
    const int height = strokeBase(frame, first).z + local.x * strokeStep(frame.perI).z
        + local.y * strokeStep(frame.perJ).z + local.z * strokeStep(frame.perK).z;
    return std::abs(height) <= frame.halfThickness;
}

int steepestAxis(const CapsuleFrame& frame)
{
    const glm::ivec3 rise(
        strokeStep(frame.perI).z, strokeStep(frame.perJ).z, strokeStep(frame.perK).z);
    int main = 0;
    for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(rise[axis]) > std::abs(rise[main]))
            main = axis;
    }
    return main;
}

std::vector<std::uint32_t> bricksNear(
    const CapsuleFrame& frame, const Capsule& capsule, const BrickGrid& grid)
{
    // In doubles with margin: this only picks bricks whose voxels the rules then decide on.
    const glm::dmat3 perVoxel{glm::dvec3(strokeStep(frame.perI)),
        glm::dvec3(strokeStep(frame.perJ)), glm::dvec3(strokeStep(frame.perK))};
    const glm::dmat3 toIndex = glm::inverse(perVoxel);
    const glm::dvec3 origin(strokeBase(frame, glm::ivec3(0)));
    const glm::dvec3 from(capsule.from);
    const glm::dvec3 along = glm::dvec3(capsule.direction) / 16384.0 * double(capsule.length);
    const double slack = 4.0 * double(1 << frame.shift) + 1024.0;
    const double radius =
        double(std::max(frame.radius - capsule.less, 0)) + double(frame.rampHalfWidth) + slack;
    // A flat one is thin along its axis.
    const double thickness = frame.isFlat ? double(frame.halfThickness) + slack : radius;
    const glm::dvec3 around(radius, radius, thickness);
    const glm::dvec3 low = glm::min(from, from + along) - around;
    const glm::dvec3 high = glm::max(from, from + along) + around;

    glm::dvec3 lowIndex(1e18);
    glm::dvec3 highIndex(-1e18);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 at((corner & 1) ? high.x : low.x, (corner & 2) ? high.y : low.y,
            (corner & 4) ? high.z : low.z);
        lowIndex = glm::min(lowIndex, toIndex * (at - origin));
        highIndex = glm::max(highIndex, toIndex * (at - origin));
    }
    const glm::dvec3 last = glm::dvec3(grid.volumeSize) - 1.0;
    if (glm::any(glm::greaterThan(lowIndex, last + 1.0))
        || glm::any(glm::lessThan(highIndex, glm::dvec3(-1.0))))
        return {};
    const glm::ivec3 first(glm::floor(glm::clamp(lowIndex - 1.0, glm::dvec3(0.0), last) / 16.0));
    const glm::ivec3 end(glm::floor(glm::clamp(highIndex + 1.0, glm::dvec3(0.0), last) / 16.0));

    const glm::dvec3 halfBrick((BrickGrid::side - 1) / 2.0);
    glm::dvec3 halfExtent(0.0);
    double halfDiagonal = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        halfExtent += glm::abs(perVoxel[axis]) * halfBrick.x;
        halfDiagonal += glm::length(perVoxel[axis]) * halfBrick.x;
    }
    const glm::ivec3 bricks = grid.bricks();
    std::vector<std::uint32_t> found;
    for (int z = first.z; z <= end.z; ++z) {
        for (int y = first.y; y <= end.y; ++y) {
            for (int x = first.x; x <= end.x; ++x) {
                const glm::dvec3 voxel = glm::dvec3(x, y, z) * double(BrickGrid::side) + halfBrick;
                glm::dvec3 centre = origin + perVoxel * voxel;
                if (glm::any(glm::greaterThan(centre - halfExtent, high))
                    || glm::any(glm::lessThan(centre + halfExtent, low)))
                    continue;
                if (frame.isFlat)
                    centre.z = from.z;
                const bool isFar = frame.isSquare
                    ? passesBeside(centre - from, along, around + halfExtent)
                    : distanceToLine(centre, from, along) > halfDiagonal + radius;
                if (isFar)
                    continue;
                found.push_back(std::uint32_t(x + bricks.x * (y + bricks.y * z)));
            }
        }
    }
    return found;
}

} // namespace core

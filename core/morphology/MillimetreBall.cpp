// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/MillimetreBall.h"

#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace core {

namespace {

glm::dmat3 productsOfAxes(const VolumeGeometry& geometry)
{
    const glm::dmat3 axes(geometry.indexToWorld);
    return glm::transpose(axes) * axes;
}

/// How many voxels from its centre the ball reaches along each axis. On a sheared grid that is more
/// than along the axis itself.
glm::dvec3 reachOf(const glm::dmat3& products, double radiusMm)
{
    const glm::dmat3 inverse = glm::inverse(products);
    return radiusMm
        * glm::dvec3(std::sqrt(inverse[0][0]), std::sqrt(inverse[1][1]), std::sqrt(inverse[2][2]));
}

/// The last of the ball's steps from one of them on; steps in the ball are without gaps along x.
int lastStep(const MillimetreBall& ball, int from, int y, int z, int direction)
{
    int near = from;
    int far = from + direction * (2 * ball.extent.x + 1); // outside for certain
    while (std::abs(far - near) > 1) {
        const int middle = near + (far - near) / 2;
        (ball.holds(middle, y, z) ? near : far) = middle;
    }
    return near;
}

/// Where the squared length along x is least: at one of the two steps about the real minimum.
int nearestStep(const MillimetreBall& ball, int y, int z)
{
    const std::int64_t slope = -(ball.xy * y + ball.xz * z);
    auto step = int(slope / ball.xx);
    for (const int next : {step - 1, step + 1}) {
        if (ball.squared(next, y, z) < ball.squared(step, y, z))
            step = next;
    }
    return step;
}

std::optional<BallRow> rowAt(const MillimetreBall& ball, int y, int z)
{
    const int nearest = nearestStep(ball, y, z);
    if (!ball.holds(nearest, y, z))
        return std::nullopt;
    return BallRow{.y = y,
        .z = z,
        .from = lastStep(ball, nearest, y, z, -1),
        .to = lastStep(ball, nearest, y, z, 1)};
}

} // namespace

double ballVoxels(const VolumeGeometry& geometry, double radiusMm)
{
    const glm::dvec3 reach = reachOf(productsOfAxes(geometry), radiusMm);
    return std::max({reach.x, reach.y, reach.z});
}

MillimetreBall ballOf(const VolumeGeometry& geometry, double radiusMm)
{
    glm::dmat3 products = productsOfAxes(geometry);
    constexpr double straight = 1.75e-4; // the cosine that is left of a right angle, to 0.01°
    bool isStraight = true;
    for (const auto& [one, other] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
        isStraight = isStraight
            && std::abs(products[one][other])
                <= straight * std::sqrt(products[one][one] * products[other][other]);
    if (isStraight)
        products = glm::dmat3(glm::dvec3(products[0][0], 0.0, 0.0),
            glm::dvec3(0.0, products[1][1], 0.0), glm::dvec3(0.0, 0.0, products[2][2]));

    MillimetreBall ball;
    const glm::dvec3 reach = reachOf(products, radiusMm);
    ball.extent = glm::ivec3(glm::floor(reach * (1.0 + 1e-6))) + 1;
    // No step is longer than a box of the volume with the ball around it.
    const glm::dvec3 longest(geometry.size + 2 * ball.extent);
    const double greatest = std::max({products[0][0] * longest.x * longest.x,
        products[1][1] * longest.y * longest.y, products[2][2] * longest.z * longest.z});
    int exponent = 0;
    static_cast<void>(std::frexp(greatest, &exponent)); // greatest < 2^exponent
    constexpr int bits = 57; // of the longest step along one axis; all of them together: 60
    const auto whole = [&](double number) {
        return std::int64_t(std::floor(std::ldexp(number, bits - exponent) + 0.5));
    };
    ball.xx = std::max<std::int64_t>(1, whole(products[0][0]));
    ball.yy = std::max<std::int64_t>(1, whole(products[1][1]));
    ball.zz = std::max<std::int64_t>(1, whole(products[2][2]));
    ball.xy = whole(products[0][1]);
    ball.xz = whole(products[0][2]);
    ball.yz = whole(products[1][2]);
    // A hair's breadth of rounding must not decide about a voxel that lies just at the radius.
    constexpr double slack = 1e-6;
    ball.squaredRadius = whole(radiusMm * radiusMm * (1.0 + slack));
    return ball;
}

MillimetreBall flatBallOf(const VolumeGeometry& geometry, double radiusMm)
{
    MillimetreBall ball = ballOf(geometry, radiusMm);
    ball.isFlat = glm::equal(geometry.size, glm::ivec3(1));
    return ball;
}

std::vector<BallRow> ballRows(const MillimetreBall& ball, const glm::ivec3& box)
{
    const glm::ivec3 most = glm::min(ball.extent, box - 1);
    std::vector<BallRow> rows;
    for (int z = -most.z; z <= most.z; ++z) {
        for (int y = -most.y; y <= most.y; ++y) {
            if (const std::optional<BallRow> row = rowAt(ball, y, z))
                rows.push_back(*row);
        }
    }
    return rows;
}

std::int64_t voxelCount(const MillimetreBall& ball)
{
    const int lastY = ball.isFlat.y ? 0 : ball.extent.y;
    const int lastZ = ball.isFlat.z ? 0 : ball.extent.z;
    std::int64_t count = 0;
    for (int z = -lastZ; z <= lastZ; ++z) {
        for (int y = -lastY; y <= lastY; ++y) {
            const std::optional<BallRow> row = rowAt(ball, y, z);
            if (row && !ball.isFlat.x)
                count += row->to - row->from + 1;
            else if (row && row->from <= 0 && row->to >= 0)
                ++count;
        }
    }
    return count;
}

} // namespace core

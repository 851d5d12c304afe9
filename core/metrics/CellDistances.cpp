// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/CellDistances.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Steps of the lengths and angles that a form has: the first one along the frame's first axis, the
/// second one in the plane of its first two (Cholesky's decomposition).
glm::dmat3 stepsOf(const MillimetreBall& form)
{
    glm::dmat3 steps(0.0);
    steps[0].x = std::sqrt(double(form.xx));
    steps[1].x = double(form.xy) / steps[0].x;
    steps[2].x = double(form.xz) / steps[0].x;
    steps[1].y = std::sqrt(std::max(1.0, double(form.yy) - steps[1].x * steps[1].x));
    steps[2].y = (double(form.yz) - steps[1].x * steps[2].x) / steps[1].y;
    steps[2].z = std::sqrt(
        std::max(0.0, double(form.zz) - steps[2].x * steps[2].x - steps[2].y * steps[2].y));
    return steps;
}

/// The square of a way, as a whole number that is not above it, however its parts were rounded.
/// @param apart the least of the way along each axis of the frame; below 0: nothing
std::int64_t cautiousSquare(const glm::dvec3& apart)
{
    constexpr double unit = 1.0;
    constexpr double less = 1.0 - 1e-9;
    const glm::dvec3 way = glm::max(apart - unit, glm::dvec3(0.0));
    return std::int64_t(std::floor(less * glm::dot(way, way)));
}

} // namespace

CellDistances::CellDistances(const VolumeGeometry& geometry)
{
    constexpr double anyRadiusMm = 1.0; // only the lengths of steps are asked for
    m_form = ballOf(geometry, anyRadiusMm);
    m_steps = stepsOf(m_form);
}

std::int64_t CellDistances::leastSquared(const VoxelBox& from, const VoxelBox& to) const
{
    const glm::ivec3 least = between(from.maximum - 1, to.minimum);
    const glm::ivec3 most = between(from.minimum, to.maximum - 1);
    if (m_form.isStraight()) {
        const glm::ivec3 apart = glm::max(glm::max(least, -most), glm::ivec3(0));
        return m_form.squared(apart.x, apart.y, apart.z);
    }
    // Along each axis of the frame for itself: the ways that steps of the boxes may make there.
    glm::dvec3 low(0.0);
    glm::dvec3 high(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 one = double(least[axis]) * m_steps[axis];
        const glm::dvec3 other = double(most[axis]) * m_steps[axis];
        low += glm::min(one, other);
        high += glm::max(one, other);
    }
    return cautiousSquare(glm::max(low, -high));
}

} // namespace core

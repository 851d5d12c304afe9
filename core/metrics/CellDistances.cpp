// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/CellDistances.h"

#include "core/volume/UnevenSlices.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace core {

namespace {

constexpr double anyRadiusMm = 1.0; // only the lengths of steps are asked for of the ball

/// Of the unit in which squares are counted between uneven slices. Many steps of a voxel keep their
/// length by them.
constexpr int fractionBits = 20;

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

/// The least and the greatest place of the borders of a box's slices along each axis.
std::pair<glm::dvec3, glm::dvec3> rangeOf(
    const std::vector<glm::i64vec3>& borders, const VoxelBox& box)
{
    glm::i64vec3 low = borders[std::size_t(box.minimum.z)];
    glm::i64vec3 high = low;
    for (int z = box.minimum.z + 1; z <= box.maximum.z; ++z) {
        low = glm::min(low, borders[std::size_t(z)]);
        high = glm::max(high, borders[std::size_t(z)]);
    }
    const double unit = std::ldexp(1.0, -fractionBits);
    return {unit * glm::dvec3(low), unit * glm::dvec3(high)};
}

} // namespace

CellDistances::CellDistances(const VolumeGeometry& geometry)
    : m_form(ballOf(geometry, anyRadiusMm))
{
    if (geometry.slicePositions.empty())
        m_steps = stepsOf(m_form);
    else
        placeBorders(geometry);
}

void CellDistances::placeBorders(const VolumeGeometry& geometry)
{
    const glm::dmat3 axes(geometry.indexToWorld);
    glm::dmat3 frame(1.0);
    frame[0] = glm::normalize(axes[0]);
    frame[2] = glm::normalize(glm::cross(axes[0], axes[1]));
    frame[1] = glm::cross(frame[2], frame[0]);
    const glm::dmat3 inFrame = glm::transpose(frame);
    const glm::dvec3 column(glm::length(axes[0]), 0.0, 0.0);
    glm::dvec3 row = inFrame * axes[1];
    if (m_form.isStraight())
        row.x = 0.0; // as in the form, where what little is left of it does not count
    const glm::dvec3 first = worldBetweenSlices(geometry, {0.0, 0.0, -0.5});
    std::vector<glm::dvec3> borders;
    double farthest = 0.0;
    for (int k = 0; k <= geometry.size.z; ++k) {
        borders.push_back(inFrame * (worldBetweenSlices(geometry, {0.0, 0.0, k - 0.5}) - first));
        farthest = std::max(farthest, glm::length(borders.back()));
    }
    const double longest =
        geometry.size.x * glm::length(column) + geometry.size.y * glm::length(row) + 2.0 * farthest;
    int exponent = 0;
    static_cast<void>(std::frexp(longest, &exponent)); // longest < 2^exponent
    constexpr int bits = 29; // of a way along one axis; the squares of all three together: 60
    const auto whole = [&](const glm::dvec3& way) {
        return glm::i64vec3(
            glm::floor(way * std::ldexp(1.0, bits - exponent + fractionBits) + 0.5));
    };
    for (const glm::dvec3& border : borders)
        m_borders.push_back(whole(border));
    m_columnStep = whole(column);
    m_rowStep = whole(row);
    const double unit = std::ldexp(1.0, -fractionBits);
    m_steps =
        glm::dmat3(unit * glm::dvec3(m_columnStep), unit * glm::dvec3(m_rowStep), glm::dvec3(0.0));
}

std::int64_t CellDistances::squaredBetweenBorders(
    const glm::ivec3& from, const glm::ivec3& to) const
{
    const glm::ivec3 step = between(from, to);
    glm::i64vec3 way = std::int64_t(step.x) * m_columnStep + std::int64_t(step.y) * m_rowStep;
    if (to.z > from.z)
        way += m_borders[std::size_t(to.z)] - m_borders[std::size_t(from.z) + 1];
    else if (to.z < from.z)
        way += m_borders[std::size_t(to.z) + 1] - m_borders[std::size_t(from.z)];
    constexpr std::int64_t half = std::int64_t(1) << (fractionBits - 1);
    std::int64_t squares = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t units = (std::abs(way[axis]) + half) >> fractionBits;
        squares += units * units;
    }
    return squares;
}

std::int64_t CellDistances::leastSquared(const VoxelBox& from, const VoxelBox& to) const
{
    const glm::ivec3 least = between(from.maximum - 1, to.minimum);
    const glm::ivec3 most = between(from.minimum, to.maximum - 1);
    if (m_borders.empty() && m_form.isStraight()) {
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
    if (!m_borders.empty()) {
        const auto [fromLow, fromHigh] = rangeOf(m_borders, from);
        const auto [toLow, toHigh] = rangeOf(m_borders, to);
        low += toLow - fromHigh;
        high += toHigh - fromLow;
    }
    return cautiousSquare(glm::max(low, -high));
}

} // namespace core

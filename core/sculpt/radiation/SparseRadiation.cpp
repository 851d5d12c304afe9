// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/radiation/SparseRadiation.h"

#include <algorithm>
#include <cmath>

namespace core::radiation {

namespace {

constexpr double positionStep = 1.0 / 256.0;
constexpr double sigmasPerRadius = 2.5;

std::uint32_t product(std::uint32_t a, std::uint32_t b)
{
    return std::uint32_t(std::uint64_t(a) * b >> sparseWeightBits);
}

} // namespace

glm::dvec3 sparseRadii(int radius, const glm::dvec3& spacingMm)
{
    const double finest = std::min({spacingMm.x, spacingMm.y, spacingMm.z});
    const glm::dvec3 radii =
        glm::round(double(radius) * (finest / spacingMm) / positionStep) * positionStep;
    return glm::max(radii, glm::dvec3(smallestSparseRadius));
}

SparseFootprint sparseFootprint(const glm::dvec3& index, const glm::dvec3& radii)
{
    SparseFootprint footprint;
    for (int axis = 0; axis < 3; ++axis) {
        const double at = std::round(index[axis] / positionStep) * positionStep;
        const double radius = radii[axis];
        const double sigma = radius / sigmasPerRadius;
        footprint.first[axis] = int(std::ceil(at - radius));
        footprint.count[axis] = int(std::floor(at + radius)) - footprint.first[axis] + 1;
        for (int i = 0; i < footprint.count[axis]; ++i) {
            const double away = (footprint.first[axis] + i - at) / sigma;
            footprint.weights[std::size_t(axis)][std::size_t(i)] =
                std::uint32_t(std::lround(std::exp(-0.5 * away * away) * (1u << sparseWeightBits)));
        }
    }
    return footprint;
}

std::uint32_t sparseContribution(const SparseFootprint& footprint, const glm::ivec3& voxel)
{
    const glm::ivec3 at = voxel - footprint.first;
    if (glm::any(glm::lessThan(at, glm::ivec3(0)))
        || glm::any(glm::greaterThanEqual(at, footprint.count)))
        return 0;
    const std::uint32_t plane =
        product(footprint.weights[0][std::size_t(at.x)], footprint.weights[1][std::size_t(at.y)]);
    const std::uint32_t weight = product(plane, footprint.weights[2][std::size_t(at.z)]);
    constexpr std::uint32_t drop = sparseWeightBits - sparseSumBits;
    return (weight + (1u << (drop - 1))) >> drop;
}

} // namespace core::radiation

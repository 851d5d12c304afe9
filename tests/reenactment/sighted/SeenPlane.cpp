// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/SeenPlane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reenact {

namespace {

/// How far from a reading its two sides are looked at.
constexpr std::array<double, 2> besideMm{3.0, 5.0};
/// Times the noise: by so much the sides of an edge differ.
constexpr double edgeInNoise = 2.0;
/// Points of a reading between the two that show which way it runs.
constexpr std::size_t tangentPoints = 3;

/// How much neighbouring values differ where nothing else does: the median of all.
double noiseOf(const SeenPlane& view)
{
    const int count = 2 * view.greyHalf + 1;
    std::vector<float> steps;
    for (int j = 0; j < count; j += 2) {
        for (int i = 0; i + 1 < count; i += 2) {
            const std::size_t at = std::size_t(j) * std::size_t(count) + std::size_t(i);
            // Beyond the volume its rim goes on unchanged.
            if (view.grey[at] != view.grey[at + 1])
                steps.push_back(std::abs(view.grey[at] - view.grey[at + 1]));
        }
    }
    if (steps.empty())
        return 1.0;
    const auto middle = steps.begin() + std::ptrdiff_t(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return std::max(1.0, double(*middle));
}

} // namespace

double SeenPlane::greyAt(const glm::dvec3& placeLps) const
{
    const glm::dvec3 off = placeLps - plane.middleLps;
    const auto step = [this](double mm) {
        return std::clamp(int(std::lround(mm / greyStepMm)), -greyHalf, greyHalf) + greyHalf;
    };
    const int column = step(glm::dot(off, plane.rightLps));
    const int row = step(glm::dot(off, plane.downLps));
    return double(grey[std::size_t(row) * std::size_t(2 * greyHalf + 1) + std::size_t(column)]);
}

double edgeShare(
    const SeenPlane& view, const std::function<bool(const glm::dvec3& placeLps)>& isNear)
{
    const double least = edgeInNoise * noiseOf(view);
    int points = 0;
    int edges = 0;
    for (const PlaneLine& line : view.readings) {
        const std::size_t count = line.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (!isNear(line[i]))
                continue;
            const glm::dvec3 along = line[(i + tangentPoints) % count]
                - line[(i + count - tangentPoints % count) % count];
            if (glm::length(along) < 1e-6)
                continue;
            const glm::dvec3 across = glm::normalize(glm::cross(view.plane.normalLps(), along));
            double apart = 0.0;
            for (const double mm : besideMm)
                apart += view.greyAt(line[i] + mm * across) - view.greyAt(line[i] - mm * across);
            ++points;
            edges += std::abs(apart) / double(besideMm.size()) > least ? 1 : 0;
        }
    }
    return points == 0 ? 0.0 : double(edges) / double(points);
}

} // namespace reenact

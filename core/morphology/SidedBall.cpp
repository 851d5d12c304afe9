// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/SidedBall.h"

#include "core/volume/VolumeGeometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {

namespace {

int bitsOf(int number)
{
    int bits = 0;
    for (; number > 0; number /= 2)
        ++bits;
    return bits;
}

} // namespace

std::array<int, 3> axesOfPatient(const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    std::array<int, 3> order{0, 1, 2};
    std::array<int, 3> best = order;
    double most = -1.0;
    do {
        double sum = 0.0;
        for (int patient = 0; patient < 3; ++patient) {
            const int axis = order.at(std::size_t(patient));
            sum += std::abs(geometry.indexToWorld[axis][patient]) / spacing[axis];
        }
        if (sum > most) {
            most = sum;
            best = order;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

SidedBall sidedBallOf(const VolumeGeometry& geometry, const SixMargins& margins)
{
    const std::array<int, 3> axes = axesOfPatient(geometry);
    const glm::dvec3 spacing = geometry.spacingMm();
    // Towards smaller and greater numbers of L, P and S.
    const std::array<std::array<double, 2>, 3> ofPatient{{{margins.right, margins.left},
        {margins.anterior, margins.posterior}, {margins.inferior, margins.superior}}};
    const int bits = 60 - 2 * bitsOf(std::max({geometry.size.x, geometry.size.y, geometry.size.z}));
    constexpr double slack = 1e-6;
    SidedBall ball;
    ball.whole = std::int64_t(std::floor(std::ldexp(1.0 + slack, bits)));
    for (int patient = 0; patient < 3; ++patient) {
        const int axis = axes.at(std::size_t(patient));
        const bool isForwards = geometry.indexToWorld[axis][patient] >= 0.0;
        for (std::size_t side = 0; side < 2; ++side) {
            const double mm = ofPatient.at(std::size_t(patient)).at(isForwards ? side : 1 - side);
            std::int64_t squared = ball.whole + 1;
            const double share = mm > 0.0 ? spacing[axis] / mm : 2.0;
            if (share < 2.0)
                squared = std::clamp<std::int64_t>(
                    std::int64_t(std::floor(std::ldexp(share * share, bits) + 0.5)), 1,
                    ball.whole + 1);
            ball.squared.at(std::size_t(axis)).at(side) = squared;
            int& steps = side == 0 ? ball.before[axis] : ball.behind[axis];
            while (steps < geometry.size[axis]
                && squared <= ball.whole / ((std::int64_t(steps) + 1) * (steps + 1)))
                ++steps;
        }
    }
    return ball;
}

SidedBall reversed(const SidedBall& ball)
{
    SidedBall other = ball;
    std::swap(other.before, other.behind);
    for (std::array<std::int64_t, 2>& sides : other.squared)
        std::swap(sides[0], sides[1]);
    return other;
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/CounterRandom.h"

#include <cmath>
#include <numbers>

namespace reenact {

/// SplitMix64's finish.
std::uint64_t CounterRandom::mixed(std::uint64_t value)
{
    value += 0x9e3779b97f4a7c15U;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9U;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebU;
    return value ^ (value >> 31);
}

double CounterRandom::normal()
{
    const double first = 1.0 - unit();
    const double second = unit();
    return std::sqrt(-2.0 * std::log(first)) * std::cos(2.0 * std::numbers::pi * second);
}

glm::dvec3 CounterRandom::direction()
{
    const double z = within(-1.0, 1.0);
    const double turn = within(0.0, 2.0 * std::numbers::pi);
    const double across = std::sqrt(1.0 - z * z);
    return {across * std::cos(turn), across * std::sin(turn), z};
}

double SmoothNoise::at(const glm::dvec3& place) const
{
    const glm::dvec3 scaled = place / m_width;
    const glm::dvec3 cell = glm::floor(scaled);
    const glm::dvec3 part = scaled - cell;
    const glm::dvec3 share = part * part * (3.0 - 2.0 * part);
    double sum = 0.0;
    double squares = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::ivec3 node = glm::ivec3(cell) + step + 4096;
        double weight = 1.0;
        for (int axis = 0; axis < 3; ++axis)
            weight *= step[axis] == 1 ? share[axis] : 1.0 - share[axis];
        const auto counter =
            (std::uint64_t(node.z) << 40) ^ (std::uint64_t(node.y) << 20) ^ std::uint64_t(node.x);
        // Even over −√3 … √3, whose deviation is 1.
        sum += weight * std::numbers::sqrt3 * (2.0 * m_random.unitAt(counter) - 1.0);
        squares += weight * weight;
    }
    return sum / std::sqrt(squares);
}

} // namespace reenact

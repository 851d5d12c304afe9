// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>

/// Counter-based randomness: a value depends on where it is asked for and on nothing else, so the
/// order of threads does not matter.
namespace core::demo {

/// A well mixed 32-bit word of three coordinates (finaliser of MurmurHash3).
inline std::uint32_t hash(std::int32_t x, std::int32_t y, std::int32_t z)
{
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343U
        ^ static_cast<std::uint32_t>(y) * 0xd8163841U ^ static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
    h = (h ^ (h >> 16)) * 0x85ebca6bU;
    h = (h ^ (h >> 13)) * 0xc2b2ae35U;
    return h ^ (h >> 16);
}

/// In [−1, 1).
inline float uniform(std::uint32_t word)
{
    return static_cast<float>(static_cast<std::int32_t>(word)) * (1.0F / 2147483648.0F);
}

/// Close to a normal distribution, deviation 1: the sum of a word's four bytes.
inline float gaussian(std::uint32_t word)
{
    const auto sum = static_cast<float>(
        (word & 255U) + ((word >> 8) & 255U) + ((word >> 16) & 255U) + (word >> 24));
    return (sum - 510.0F) * (1.0F / 147.8F);
}

struct NoiseSample {
    float value = 0.0F; ///< about −1 … 1
    glm::vec3 slope{0.0F};
};

/// Smooth value noise with its gradient, lattice constant 1.
inline NoiseSample noise(const glm::vec3& p, int seed)
{
    const glm::vec3 cell = glm::floor(p);
    const glm::vec3 f = p - cell;
    const auto x = static_cast<std::int32_t>(cell.x) + seed * 101;
    const auto y = static_cast<std::int32_t>(cell.y) + seed * 57;
    const auto z = static_cast<std::int32_t>(cell.z);
    const glm::vec3 u = f * f * f * (f * (f * 6.0F - 15.0F) + 10.0F);
    const glm::vec3 du = 30.0F * f * f * (f * (f - 2.0F) + 1.0F);
    const float a = uniform(hash(x, y, z));
    const float b = uniform(hash(x + 1, y, z));
    const float c = uniform(hash(x, y + 1, z));
    const float d = uniform(hash(x + 1, y + 1, z));
    const float e = uniform(hash(x, y, z + 1));
    const float g = uniform(hash(x + 1, y, z + 1));
    const float h = uniform(hash(x, y + 1, z + 1));
    const float i = uniform(hash(x + 1, y + 1, z + 1));
    const float k1 = b - a;
    const float k2 = c - a;
    const float k3 = e - a;
    const float k4 = a - b - c + d;
    const float k5 = a - c - e + h;
    const float k6 = a - b - e + g;
    const float k7 = -a + b + c - d + e - g - h + i;
    NoiseSample sample;
    sample.value = a + k1 * u.x + k2 * u.y + k3 * u.z + k4 * u.x * u.y + k5 * u.y * u.z
        + k6 * u.z * u.x + k7 * u.x * u.y * u.z;
    sample.slope = du
        * glm::vec3(k1 + k4 * u.y + k6 * u.z + k7 * u.y * u.z,
            k2 + k5 * u.z + k4 * u.x + k7 * u.z * u.x, k3 + k6 * u.x + k5 * u.y + k7 * u.x * u.y);
    return sample;
}

} // namespace core::demo

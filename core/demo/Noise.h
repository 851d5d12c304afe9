// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>

/// Counter-based randomness: a value depends only on the place for which it is computed, so the
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

/// Gradient noise (K. Perlin, Improving Noise, 2002) with its slope, lattice constant 1.
NoiseSample noise(const glm::vec3& p, int seed);

} // namespace core::demo

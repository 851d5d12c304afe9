// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace reenact {

/// Random numbers by counter: each is made from seed, stream and place alone, so that one more that
/// is drawn somewhere changes no other.
class CounterRandom {
public:
    CounterRandom(std::uint64_t seed, std::uint64_t stream)
        : m_key(mixed(mixed(seed) + stream))
    {
    }
    [[nodiscard]] double unit() { return unitAt(m_counter++); } ///< [0, 1)
    [[nodiscard]] double within(double low, double high) { return low + (high - low) * unit(); }
    [[nodiscard]] double normal(); ///< mean 0, deviation 1
    [[nodiscard]] glm::dvec3 direction(); ///< a unit vector, every one as likely

    [[nodiscard]] std::uint64_t at(std::uint64_t counter) const { return mixed(m_key + counter); }
    [[nodiscard]] double unitAt(std::uint64_t counter) const
    {
        return double(at(counter) >> 11) * 0x1p-53;
    }

private:
    [[nodiscard]] static std::uint64_t mixed(std::uint64_t value);

    std::uint64_t m_key;
    std::uint64_t m_counter = 0;
};

/// Smooth noise: mean 0, deviation about 1, alike over about @p width.
class SmoothNoise {
public:
    SmoothNoise(std::uint64_t seed, std::uint64_t stream, double width)
        : m_random(seed, stream)
        , m_width(width)
    {
    }
    [[nodiscard]] double at(const glm::dvec3& place) const;

private:
    CounterRandom m_random;
    double m_width;
};

} // namespace reenact

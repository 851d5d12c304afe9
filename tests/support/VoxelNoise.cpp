// SPDX-License-Identifier: Apache-2.0
#include "tests/support/VoxelNoise.h"

#include "tests/support/FrameFixture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace test {

namespace {

double keys(double x)
{
    const double a = std::abs(x);
    return a < 1.0 ? (1.5 * a - 2.5) * a * a + 1.0
        : a < 2.0  ? ((-0.5 * a + 2.5) * a - 4.0) * a + 2.0
                   : 0.0;
}

template <class Kernel>
double gathered(const VoxelNoise& noise, const glm::dvec3& index, int reach, Kernel kernel)
{
    const glm::ivec3 base(glm::floor(index));
    double sum = 0.0;
    for (int z = base.z - reach; z <= base.z + reach + 1; ++z)
        for (int y = base.y - reach; y <= base.y + reach + 1; ++y)
            for (int x = base.x - reach; x <= base.x + reach + 1; ++x)
                sum += kernel(index.x - x) * kernel(index.y - y) * kernel(index.z - z)
                    * noise.codeAt({x, y, z});
    return sum;
}

} // namespace

double VoxelNoise::codeAt(const glm::ivec3& voxel) const
{
    const glm::ivec3 held = glm::clamp(voxel, glm::ivec3(0), m_geometry.size - 1);
    std::uint32_t hash = std::uint32_t(held.x) * 73856093u ^ std::uint32_t(held.y) * 19349663u
        ^ std::uint32_t(held.z) * 83492791u;
    hash = (hash ^ hash >> 13) * 0x5bd1e995u;
    hash ^= hash >> 15;
    return double(hash % std::uint32_t(m_highest + 1));
}

std::function<double(const glm::dvec3&)> VoxelNoise::codes() const
{
    return [*this](const glm::dvec3& lps) {
        return codeAt(glm::ivec3(glm::round(m_geometry.toIndex(lps))));
    };
}

double VoxelNoise::linearAt(const glm::dvec3& lps) const
{
    return gathered(*this, m_geometry.toIndex(lps), 0,
        [](double x) { return std::max(1.0 - std::abs(x), 0.0); });
}

double VoxelNoise::cubicAt(const glm::dvec3& lps) const
{
    return gathered(*this, m_geometry.toIndex(lps), 1, keys);
}

double VoxelNoise::depthOf(const glm::dvec3& lps) const
{
    const glm::dvec3 index = m_geometry.toIndex(lps);
    const glm::dvec3 room = glm::min(index + 0.5, glm::dvec3(m_geometry.size) - 0.5 - index);
    return std::min({room.x, room.y, room.z});
}

double greyOf(double value, const core::WindowLevel& window)
{
    const double part = (value - (window.centre - 0.5)) / (window.width - 1.0) + 0.5;
    return std::clamp(part, 0.0, 1.0) * 255.0;
}

core::VolumeGeometry tiltedGeometry(const glm::ivec3& size)
{
    core::VolumeGeometry geometry = centredGeometry(size, {0.7, 1.1, 2.0});
    geometry.indexToWorld[2][1] = 0.6; // gantry tilt
    geometry.indexToWorld[0][2] = 0.2;
    return geometry;
}

} // namespace test

// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/fields/Radiation.h"

#include "core/sculpt/radiation/Radiation.h"

#include <algorithm>

namespace reference {

namespace {

/// Sum along one axis. Three of them in a row are the triple sum: nothing is rounded in between.
DenseArray<std::uint32_t> weighted(const DenseArray<std::uint32_t>& field, int axis)
{
    DenseArray<std::uint32_t> sums = field;
    for (int z = 0; z < field.size.z; ++z) {
        for (int y = 0; y < field.size.y; ++y) {
            for (int x = 0; x < field.size.x; ++x) {
                std::uint32_t sum = 0;
                for (int tap = -core::radiation::radius; tap <= core::radiation::radius; ++tap) {
                    glm::ivec3 voxel(x, y, z);
                    voxel[axis] += tap;
                    if (field.contains(voxel))
                        sum += field.at(voxel)
                            * core::radiation::weights[std::size_t(tap + core::radiation::radius)];
                }
                sums.at({x, y, z}) = sum;
            }
        }
    }
    return sums;
}

int greatestAround(const DenseArray<std::uint32_t>& blur, const glm::ivec3& centre)
{
    std::uint32_t greatest = 0;
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const glm::ivec3 voxel = centre + glm::ivec3(dx, dy, dz);
                if (blur.contains(voxel))
                    greatest = std::max(greatest, blur.at(voxel));
            }
        }
    }
    return int(greatest);
}

} // namespace

DenseArray<std::uint8_t> radiation(const DenseArray<std::uint8_t>& coverage)
{
    DenseArray<std::uint8_t> result = coverage;
    if (std::all_of(coverage.values.begin(), coverage.values.end(),
            [](std::uint8_t value) { return value == 0; }))
        return result;

    DenseArray<std::uint32_t> blur{coverage.size, {coverage.values.begin(), coverage.values.end()}};
    for (int axis = 0; axis < 3; ++axis)
        blur = weighted(blur, axis);
    for (std::uint32_t& value : blur.values)
        value = (value + (1u << 23)) >> 24;

    for (int z = 0; z < coverage.size.z; ++z) {
        for (int y = 0; y < coverage.size.y; ++y) {
            for (int x = 0; x < coverage.size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const int blurred = int(blur.at(voxel));
                if (coverage.at(voxel) < 128) {
                    result.at(voxel) = std::uint8_t(std::min(blurred, 127));
                    continue;
                }
                int value = std::max(blurred, 128);
                const int greatest = greatestAround(blur, voxel);
                if (greatest < core::radiation::thinBelow)
                    value = std::max(value,
                        128
                            + core::radiation::thinLift * (core::radiation::thinBelow - greatest)
                                / core::radiation::thinBelow);
                result.at(voxel) = std::uint8_t(value);
            }
        }
    }
    return result;
}

} // namespace reference

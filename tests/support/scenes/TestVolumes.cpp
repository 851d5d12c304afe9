// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/TestVolumes.h"

#include <algorithm>

namespace test {

namespace {

template <class Code> Codes made(const glm::ivec3& size, Code code)
{
    Codes codes{size, {}};
    codes.values.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                codes.values.push_back(std::uint16_t(code(glm::ivec3(x, y, z))));
    return codes;
}

} // namespace

int randomInt(Random& random, int low, int high)
{
    return low + int(random() % std::uint32_t(high - low + 1));
}

double randomUnit(Random& random)
{
    return double(random()) / 4294967296.0;
}

glm::ivec3 randomVoxel(Random& random, const glm::ivec3& size)
{
    glm::ivec3 voxel;
    for (int axis = 0; axis < 3; ++axis)
        voxel[axis] = randomInt(random, 0, size[axis] - 1);
    return voxel;
}

Codes constantVolume(const glm::ivec3& size, std::uint16_t code)
{
    return made(size, [&](const glm::ivec3&) { return code; });
}

Codes noiseVolume(const glm::ivec3& size, int highest, Random& random)
{
    return made(size, [&](const glm::ivec3&) { return randomInt(random, 0, highest); });
}

Codes checkerboard(const glm::ivec3& size)
{
    return made(size, [](const glm::ivec3& v) { return (v.x + v.y + v.z) % 2 ? 0 : tissueCode; });
}

Codes spiralCorridor(const glm::ivec3& size)
{
    // Even rows of even slices are corridors; they are joined at alternating ends. Slices are
    // joined at the place where the last corridor of the lower one ends.
    const int lastRow = (size.y - 1) / 2;
    const auto endOf = [&](int row) { return row % 2 ? 0 : size.x - 1; };
    return made(size, [&](const glm::ivec3& v) {
        const int slice = v.z / 2;
        const int row = v.y / 2;
        if (v.z % 2) {
            const int joinRow = slice % 2 ? 0 : lastRow;
            const int joinX = slice % 2 ? 0 : endOf(lastRow);
            return v.y == 2 * joinRow && v.x == joinX ? tissueCode : 0;
        }
        if (v.y % 2)
            return v.x == endOf(row) && row < lastRow ? tissueCode : 0;
        return int(tissueCode);
    });
}

Codes zigzagCorridor(const glm::ivec3& size)
{
    const int lastRow = (size.y - 2) / 3;
    const auto endOf = [&](int row) { return row % 2 ? 0 : size.x - 1; };
    return made(size, [&](const glm::ivec3& v) {
        const int slice = v.z / 2;
        const int row = v.y / 3;
        if (v.z % 2) {
            const int joinRow = slice % 2 ? 0 : lastRow;
            const int joinX = slice % 2 ? 0 : endOf(lastRow);
            return v.y == 3 * joinRow + joinX % 2 && v.x == joinX ? tissueCode : 0;
        }
        if (v.y % 3 == 2)
            return v.x == endOf(row) && row < lastRow ? tissueCode : 0;
        return row <= lastRow && v.y % 3 == v.x % 2 ? tissueCode : 0;
    });
}

Codes balls(const glm::ivec3& size, int count, Random& random)
{
    struct Ball {
        glm::ivec3 centre;
        int radius;
    };
    std::vector<Ball> all;
    const int largest = std::max({size.x, size.y, size.z}) / 4 + 1;
    for (int i = 0; i < count; ++i)
        all.push_back({randomVoxel(random, size), randomInt(random, 1, largest)});
    return made(size, [&](const glm::ivec3& v) {
        const int noise = randomInt(random, 0, tissueCode / 4);
        for (const Ball& ball : all) {
            const glm::ivec3 d = v - ball.centre;
            if (d.x * d.x + d.y * d.y + d.z * d.z <= ball.radius * ball.radius)
                return tissueCode - noise;
        }
        return noise;
    });
}

Codes shells(const glm::ivec3& size)
{
    return made(size, [&](const glm::ivec3& v) {
        const glm::dvec3 half = glm::dvec3(size) / 2.0;
        const double r = glm::length((glm::dvec3(v) + 0.5 - half) / half);
        if (r > 0.95)
            return 0;
        if (r > 0.8 || (r > 0.55 && r < 0.7))
            return int(tissueCode);
        return 300;
    });
}

Codes slab(const glm::ivec3& size, int axis, int first, int last)
{
    return made(size,
        [&](const glm::ivec3& v) { return first <= v[axis] && v[axis] <= last ? tissueCode : 0; });
}

Bytes labelBoxes(const glm::ivec3& size, int count, Random& random)
{
    Bytes labels{size, {}};
    labels.values.assign(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), std::uint8_t(0));
    for (int box = 0; box < count; ++box) {
        const glm::ivec3 a = randomVoxel(random, size);
        const glm::ivec3 b = randomVoxel(random, size);
        const auto label = std::uint8_t(randomInt(random, 0, 4));
        for (int z = std::min(a.z, b.z); z <= std::max(a.z, b.z); ++z)
            for (int y = std::min(a.y, b.y); y <= std::max(a.y, b.y); ++y)
                for (int x = std::min(a.x, b.x); x <= std::max(a.x, b.x); ++x)
                    labels.at({x, y, z}) = label;
    }
    return labels;
}

std::vector<core::BrickImage> bricksOf(const Bytes& bytes, core::Field field, std::uint8_t plane)
{
    reference::DenseFields fields(bytes.size);
    (field == core::Field::Labels ? fields.labels(plane) : fields.coverage(plane)) = bytes;
    const core::BrickGrid grid{bytes.size};
    std::vector<core::BrickImage> images;
    for (int brick = 0; brick < grid.brickCount(); ++brick) {
        const core::BrickKey key{field, plane, std::uint32_t(brick)};
        images.push_back({key, fields.readBrick(key)});
    }
    return images;
}

} // namespace test

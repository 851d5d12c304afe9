// SPDX-License-Identifier: Apache-2.0
#include "core/refine/voxels/SmoothOccupancy.h"

#include "core/base/ParallelFor.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace core {

namespace {

/// How far a voxel reaches: G G is five wide.
constexpr int reach = 2;

/// A cube of numbers, and the same under [1 2 1] along each axis, by one smaller on each side.
struct Cube {
    int edge = 0;
    std::vector<std::int32_t> values{};

    [[nodiscard]] std::size_t place(int x, int y, int z) const
    {
        return std::size_t((z * edge + y) * edge + x);
    }
    [[nodiscard]] Cube smoothed() const
    {
        std::vector<std::int32_t> from = values;
        std::vector<std::int32_t> to(values.size(), 0);
        for (const std::size_t step :
            {std::size_t(1), std::size_t(edge), std::size_t(edge) * std::size_t(edge)}) {
            for (std::size_t i = step; i + step < from.size(); ++i)
                to[i] = from[i - step] + 2 * from[i] + from[i + step];
            std::swap(from, to);
        }
        Cube made{.edge = edge - 2};
        made.values.reserve(
            std::size_t(made.edge) * std::size_t(made.edge) * std::size_t(made.edge));
        for (int z = 1; z <= made.edge; ++z) {
            for (int y = 1; y <= made.edge; ++y) {
                for (int x = 1; x <= made.edge; ++x)
                    made.values.push_back(from[place(x, y, z)]);
            }
        }
        return made;
    }
};

} // namespace

SmoothOccupancy::SmoothOccupancy(const BoxMask& mask)
{
    if (mask.empty())
        return;
    m_first = mask.first() - reach;
    m_bricksAlong = (mask.size() + 2 * reach + edge - 1) / edge;
    const std::size_t layer = std::size_t(m_bricksAlong.x) * std::size_t(m_bricksAlong.y);
    m_table.resize(layer * std::size_t(m_bricksAlong.z), Outside);
    std::vector<std::vector<std::unique_ptr<const Brick>>> made(std::size_t(m_bricksAlong.z));
    parallelFor(m_bricksAlong.z, [&](int bz) {
        for (std::size_t i = 0; i < layer; ++i) {
            const glm::ivec3 first =
                m_first + edge * glm::ivec3(int(i) % m_bricksAlong.x, int(i) / m_bricksAlong.x, bz);
            Cube cube{.edge = stored + 2 * reach};
            std::int32_t count = 0;
            for (int z = -reach; z < stored + reach; ++z) {
                for (int y = -reach; y < stored + reach; ++y) {
                    for (int x = -reach; x < stored + reach; ++x) {
                        cube.values.push_back(mask.contains(first + glm::ivec3(x, y, z)) ? 1 : 0);
                        count += cube.values.back();
                    }
                }
            }
            std::int32_t& entry = m_table[std::size_t(bz) * layer + i];
            if (count == 0 || count == cube.edge * cube.edge * cube.edge) {
                entry = count == 0 ? Outside : Inside;
                continue;
            }
            const Cube once = cube.smoothed();
            const Cube twice = once.smoothed();
            auto brick = std::make_unique<Brick>();
            for (int v = 0; v < voxelsPerBrick; ++v) {
                const int x = v % stored;
                const int y = v / stored % stored;
                const int z = v / stored / stored;
                const std::int32_t value = 128 * once.values[once.place(x + 1, y + 1, z + 1)]
                    - twice.values[twice.place(x, y, z)];
                const bool isInside = cube.values[cube.place(x + reach, y + reach, z + reach)] == 1;
                (*brick)[std::size_t(v)] =
                    std::int16_t(isInside ? std::max<std::int32_t>(value, one / 2 + leastOff)
                                          : std::min<std::int32_t>(value, one / 2 - leastOff));
            }
            entry = std::int32_t(made[std::size_t(bz)].size());
            made[std::size_t(bz)].push_back(std::move(brick));
        }
    });
    for (std::size_t bz = 0; bz < made.size(); ++bz) {
        for (std::size_t i = 0; i < layer; ++i) {
            if (m_table[bz * layer + i] >= 0)
                m_table[bz * layer + i] += std::int32_t(m_bricks.size());
        }
        std::move(made[bz].begin(), made[bz].end(), std::back_inserter(m_bricks));
    }
}

double SmoothOccupancy::valueAt(const glm::ivec3& voxel) const
{
    const glm::ivec3 brick = voxel / edge;
    if (glm::any(glm::lessThan(voxel, glm::ivec3(0)))
        || glm::any(glm::greaterThanEqual(brick, m_bricksAlong)))
        return 0.0;
    const std::int32_t entry = entryOf(brick.x, brick.y, brick.z);
    if (entry < 0)
        return entry == Inside ? double(one) : 0.0;
    const glm::ivec3 in = voxel - edge * brick;
    return (*m_bricks[std::size_t(entry)])[std::size_t((in.z * stored + in.y) * stored + in.x)];
}

SmoothOccupancy::Place SmoothOccupancy::placeOf(const glm::dvec3& index) const
{
    constexpr double farthest = 1e9;
    Place place;
    for (int axis = 0; axis < 3; ++axis) {
        const double held = std::clamp(index[axis], -farthest, farthest);
        // Rounds towards 0, thus up where it is negative.
        int low = int(held);
        low -= double(low) > held ? 1 : 0;
        place.first[axis] = low - m_first[axis];
        place.share[axis] = held - double(low);
    }
    return place;
}

SmoothOccupancy::Corners SmoothOccupancy::cornersAt(const glm::ivec3& first) const
{
    // A negative number is a large one without its sign.
    const auto isBefore = [](int number, int bricks) {
        return unsigned(number) < unsigned(edge * bricks);
    };
    Corners corners;
    if (!isBefore(first.x, m_bricksAlong.x) || !isBefore(first.y, m_bricksAlong.y)
        || !isBefore(first.z, m_bricksAlong.z)) {
        for (int i = 0; i < 8; ++i)
            corners[std::size_t(i)] =
                valueAt(first + glm::ivec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
        return corners;
    }
    const std::int32_t entry = entryOf(first.x / edge, first.y / edge, first.z / edge);
    if (entry < 0) {
        corners.fill(entry == Inside ? double(one) : 0.0);
        return corners;
    }
    constexpr int row = stored;
    constexpr int layer = stored * stored;
    const std::int16_t* const corner = m_bricks[std::size_t(entry)]->data() + first.z % edge * layer
        + first.y % edge * row + first.x % edge;
    return {double(corner[0]), double(corner[1]), double(corner[row]), double(corner[row + 1]),
        double(corner[layer]), double(corner[layer + 1]), double(corner[layer + row]),
        double(corner[layer + row + 1])};
}

double SmoothOccupancy::Walk::at(const glm::dvec3& index)
{
    const auto [first, share] = m_field.placeOf(index);
    if (first != m_first) {
        m_corners = m_field.cornersAt(first);
        m_first = first;
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const double along = (1.0 - share.x) * m_corners[2 * i] + share.x * m_corners[2 * i + 1];
        sum += (i % 2 == 0 ? 1.0 - share.y : share.y) * (i < 2 ? 1.0 - share.z : share.z) * along;
    }
    return sum / double(one);
}

glm::dvec3 SmoothOccupancy::rise(const glm::dvec3& index) const
{
    const auto [first, share] = placeOf(index);
    const Corners corners = cornersAt(first);
    glm::dvec3 sum(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3;
        const int second = (axis + 2) % 3;
        for (int i = 0; i < 4; ++i) {
            const int before = ((i & 1) << next) | ((i >> 1) << second);
            const double weight = ((i & 1) == 0 ? 1.0 - share[next] : share[next])
                * (i < 2 ? 1.0 - share[second] : share[second]);
            sum[axis] += weight
                * (corners[std::size_t(before | (1 << axis))] - corners[std::size_t(before)]);
        }
    }
    return sum / double(one);
}

} // namespace core

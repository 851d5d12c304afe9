// SPDX-License-Identifier: Apache-2.0
#include "core/growth/coarse/CoarsePassage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core {

namespace {

std::uint32_t squareOf(double radius)
{
    return std::uint32_t(radius * radius + 1e-6);
}

} // namespace

CoarsePassage::CoarsePassage(const Passage& passage, const CoarseGrid& grid)
    : m_grid(grid)
    , m_sides(passage.spacing * grid.cell)
{
    if (!isAsked(passage))
        return;
    const int longest = std::max({m_sides.x, m_sides.y, m_sides.z});
    m_isTold = grid.isExact() || passage.reach >= longest * longest;
    if (!m_isTold)
        return;
    // Between the middles of an open cell and of one that is not the border may lie anywhere: a
    // quarter of a cell more makes a ball as often too large as too small. What it covers reaches
    // as much further, to the border.
    const glm::ivec3 beyond = m_sides - passage.spacing; // of a voxel
    const double blur = double(std::max({beyond.x, beyond.y, beyond.z}));
    const double radius = std::sqrt(double(passage.reach));
    m_room = squareOf(radius + 0.25 * blur);
    m_reach = squareOf(radius + 0.5 * blur);
    const glm::ivec3 most = glm::ivec3(std::sqrt(double(m_reach))) / m_sides + 1;
    for (int z = -most.z; z <= most.z; ++z) {
        for (int y = -most.y; y <= most.y; ++y) {
            for (int x = -most.x; x <= most.x; ++x) {
                const glm::ivec3 away = glm::ivec3(x, y, z) * m_sides;
                if (std::uint32_t(away.x * away.x + away.y * away.y + away.z * away.z) <= m_reach)
                    m_steps.emplace_back(x, y, z);
            }
        }
    }
}

std::vector<std::uint8_t> CoarsePassage::centres(const std::vector<std::uint8_t>& open) const
{
    std::vector<std::uint8_t> shut(open.size());
    std::transform(open.begin(), open.end(), shut.begin(),
        [](std::uint8_t isOpen) { return isOpen != 0 ? std::uint8_t(0) : std::uint8_t(1); });
    const std::vector<std::uint32_t> squares = squaresFrom(shut, m_room);
    for (std::size_t i = 0; i < shut.size(); ++i)
        shut[i] = squares[i] > m_room ? 1 : 0;
    return shut;
}

std::vector<std::uint8_t> CoarsePassage::covered(const std::vector<std::uint8_t>& centres) const
{
    const std::vector<std::uint32_t> squares = squaresFrom(centres, m_reach);
    std::vector<std::uint8_t> covered(centres.size());
    for (std::size_t i = 0; i < covered.size(); ++i)
        covered[i] = squares[i] <= m_reach ? 1 : 0;
    return covered;
}

std::vector<std::uint32_t> CoarsePassage::squaresFrom(
    const std::vector<std::uint8_t>& cells, std::uint32_t most) const
{
    const std::uint32_t far = most + 1;
    std::vector<std::uint32_t> squares(cells.size());
    std::transform(cells.begin(), cells.end(), squares.begin(),
        [far](std::uint8_t isOne) { return isOne != 0 ? 0U : far; });
    // One axis after the other: the squares of what is away along each add up.
    const glm::ivec3 size = m_grid.size();
    const std::array<std::size_t, 3> strides{
        1, std::size_t(size.x), std::size_t(size.x) * std::size_t(size.y)};
    std::vector<std::uint32_t> before;
    for (int axis = 0; axis < 3; ++axis) {
        before = squares;
        const std::size_t stride = strides[std::size_t(axis)];
        const auto length = std::size_t(size[axis]);
        for (std::size_t away = 1; away < length; ++away) {
            const std::uint64_t distance = std::uint64_t(m_sides[axis]) * away;
            if (distance * distance > most)
                break;
            const auto added = std::uint32_t(distance * distance);
            // Whole rows of what lies along the axis, in both directions.
            const std::size_t block = stride * length;
            for (std::size_t first = 0; first < squares.size(); first += block) {
                for (std::size_t i = first; i + away * stride < first + block; ++i) {
                    const std::size_t other = i + away * stride;
                    squares[i] = std::min(squares[i], before[other] + added);
                    squares[other] = std::min(squares[other], before[i] + added);
                }
            }
        }
    }
    return squares;
}

} // namespace core

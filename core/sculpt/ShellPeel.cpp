// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/ShellPeel.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace core {

namespace {

constexpr std::int32_t none = SurfaceHit::none;

/// Heights with the greatest of every 8 × 8 and every 64 × 64, so that most of what is too low or
/// too far is passed over as a whole.
class HeightPyramid {
public:
    explicit HeightPyramid(const PeelSheet& sheet, int sign)
        : m_size(sheet.size)
    {
        m_levels[0].size = sheet.size;
        m_levels[0].heights.reserve(sheet.surface.size());
        for (const std::int32_t z : sheet.surface)
            m_levels[0].heights.push_back(z == none ? lowest : sign * z);
        for (std::size_t level = 1; level < m_levels.size(); ++level)
            m_levels[level] = coarser(m_levels[level - 1]);
    }

    [[nodiscard]] std::int32_t at(const glm::ivec2& element) const
    {
        return m_levels[0].at(element);
    }
    [[nodiscard]] bool contains(const glm::ivec2& element) const
    {
        return element.x >= 0 && element.y >= 0 && element.x < m_size.x && element.y < m_size.y;
    }
    [[nodiscard]] const glm::ivec2& size() const { return m_size; }

    static constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
    static constexpr int side = 8; ///< of a level's cells, in cells of the one below
    struct Level {
        glm::ivec2 size{0};
        std::vector<std::int32_t> heights{};
        [[nodiscard]] std::int32_t at(const glm::ivec2& cell) const
        {
            return heights[std::size_t(cell.x) + std::size_t(size.x) * std::size_t(cell.y)];
        }
    };
    [[nodiscard]] const Level& level(std::size_t number) const { return m_levels[number]; }
    static constexpr std::size_t levelCount = 3;

private:
    static Level coarser(const Level& fine)
    {
        Level level;
        level.size = (fine.size + side - 1) / side;
        level.heights.assign(std::size_t(level.size.x) * std::size_t(level.size.y), lowest);
        for (int b = 0; b < fine.size.y; ++b) {
            for (int a = 0; a < fine.size.x; ++a) {
                std::int32_t& height = level.heights[std::size_t(a / side)
                    + std::size_t(level.size.x) * std::size_t(b / side)];
                height = std::max(height, fine.at({a, b}));
            }
        }
        return level;
    }

    glm::ivec2 m_size;
    std::array<Level, levelCount> m_levels;
};

/// h of rule 3 by distance in elements; −1 beyond the ball.
class Ball {
public:
    Ball(std::int32_t pitch, std::int32_t depth)
        : m_reach(depth / pitch)
        , m_heights(std::size_t(m_reach + 1) * std::size_t(m_reach + 1), -1)
    {
        for (std::int64_t q = 0; q <= m_reach; ++q) {
            for (std::int64_t p = 0; p <= m_reach; ++p) {
                const std::int64_t square =
                    std::int64_t(depth) * depth - (p * p + q * q) * pitch * pitch;
                if (square >= 0)
                    m_heights[std::size_t(p + q * (m_reach + 1))] =
                        std::int32_t(fixedPoint::squareRoot(square));
            }
        }
    }
    [[nodiscard]] int reach() const { return m_reach; }
    [[nodiscard]] std::int32_t height(int p, int q) const
    {
        p = std::abs(p);
        q = std::abs(q);
        return p > m_reach || q > m_reach ? -1 : m_heights[std::size_t(p + q * (m_reach + 1))];
    }

private:
    int m_reach;
    std::vector<std::int32_t> m_heights;
};

/// Looks for the greatest height + h around one element after the other.
class Search {
public:
    Search(const HeightPyramid& heights, const Ball& ball)
        : m_heights(heights)
        , m_ball(ball)
    {
    }

    std::int32_t greatest(const glm::ivec2& element)
    {
        m_centre = element;
        m_best = HeightPyramid::lowest;
        // What was best for the neighbour is a good guess, and leaves little to be looked at.
        const glm::ivec2 guess = element + m_offset;
        if (m_heights.contains(guess))
            consider(guess);
        consider(element);
        descend(
            HeightPyramid::levelCount - 1, {element - m_ball.reach(), element + m_ball.reach()});
        return m_best;
    }

private:
    void consider(const glm::ivec2& element)
    {
        const std::int32_t z = m_heights.at(element);
        if (z == HeightPyramid::lowest || std::int64_t(z) + greatestRise() <= m_best)
            return;
        const glm::ivec2 offset = element - m_centre;
        const std::int32_t h = m_ball.height(offset.x, offset.y);
        if (h >= 0 && z + h > m_best) {
            m_best = z + h;
            m_offset = offset;
        }
    }
    [[nodiscard]] std::int32_t greatestRise() const { return m_ball.height(0, 0); }

    /// The cells of a level that meet a box of elements.
    void descend(std::size_t level, const ElementBox& box)
    {
        int side = 1;
        for (std::size_t i = 0; i < level; ++i)
            side *= HeightPyramid::side;
        const HeightPyramid::Level& cells = m_heights.level(level);
        const glm::ivec2 low = glm::max(box.minimum, glm::ivec2(0)) / side;
        const glm::ivec2 high = glm::min(box.maximum / side, cells.size - 1);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                if (level == 0) {
                    consider({x, y});
                    continue;
                }
                const std::int32_t z = cells.at({x, y});
                if (z == HeightPyramid::lowest)
                    continue;
                const glm::ivec2 first = glm::ivec2(x, y) * side;
                const glm::ivec2 nearest = glm::clamp(m_centre, first, first + side - 1);
                const std::int32_t h =
                    m_ball.height(nearest.x - m_centre.x, nearest.y - m_centre.y);
                if (h >= 0 && z + h > m_best)
                    descend(level - 1, {first, first + side - 1});
            }
        }
    }

    const HeightPyramid& m_heights;
    const Ball& m_ball;
    glm::ivec2 m_centre{0};
    glm::ivec2 m_offset{0};
    std::int32_t m_best = HeightPyramid::lowest;
};

} // namespace

PeelSheet peelSheet(const ShellPeel& peel, const std::vector<SurfaceHit>& hits)
{
    PeelSheet sheet{peel.mask.first, peel.mask.size, {}};
    sheet.surface.reserve(hits.size());
    for (const SurfaceHit& hit : hits)
        sheet.surface.push_back(hit.zSurface);
    if (peel.jump < 0)
        return sheet;

    const auto width = std::ptrdiff_t(sheet.size.x);
    std::vector<std::int32_t> part(hits.size(), 0);
    std::int32_t parts = 0;
    std::int32_t largest = 0;
    std::size_t largestCount = 0;
    std::vector<std::size_t> open;
    for (std::size_t start = 0; start < hits.size(); ++start) {
        if (part[start] != 0 || sheet.surface[start] == none)
            continue;
        part[start] = ++parts;
        open.push_back(start);
        std::size_t count = 0;
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            ++count;
            const auto a = std::ptrdiff_t(at) % width;
            const auto visit = [&](bool there, std::ptrdiff_t step) {
                const auto next = std::size_t(std::ptrdiff_t(at) + step);
                if (!there || part[next] != 0 || sheet.surface[next] == none)
                    return;
                const std::int64_t difference =
                    std::int64_t(sheet.surface[next]) - sheet.surface[at];
                if (std::abs(difference) > peel.jump)
                    return;
                part[next] = parts;
                open.push_back(next);
            };
            visit(a > 0, -1);
            visit(a + 1 < width, 1);
            visit(std::ptrdiff_t(at) >= width, -width);
            visit(at + std::size_t(width) < hits.size(), width);
        }
        if (count > largestCount) {
            largest = parts;
            largestCount = count;
        }
    }
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (part[i] != largest)
            sheet.surface[i] = none;
    }
    return sheet;
}

std::vector<std::int32_t> offsetSurface(
    const PeelSheet& sheet, std::int32_t pitch, std::int32_t depth, bool restore)
{
    const int sign = restore ? -1 : 1;
    const HeightPyramid heights(sheet, sign);
    const Ball ball(pitch, depth);
    Search search(heights, ball);
    std::vector<std::int32_t> ends(sheet.surface.size(), none);
    std::size_t i = 0;
    for (int b = 0; b < sheet.size.y; ++b) {
        for (int a = 0; a < sheet.size.x; ++a, ++i) {
            if (sheet.surface[i] != none)
                ends[i] = sign * search.greatest({a, b});
        }
    }
    return ends;
}

CutColumn peelColumn(
    const CutFrame& frame, const SurfaceHit& hit, std::int32_t end, std::int32_t weight)
{
    const std::int32_t part = (weight * 255 + 128) >> 8;
    if (frame.restore)
        return restoringColumn(frame, hit, std::max(end, hit.zSurface - frame.maxDepth), part);
    return {hit.zSurface - frame.front, std::min({end, hit.zExit, hit.zSurface + frame.maxDepth}),
        part};
}

Result<void> checkSound(const ShellPeel& peel, const BrickGrid&)
{
    return checkSound(peel.frame);
}

} // namespace core

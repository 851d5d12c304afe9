// SPDX-License-Identifier: Apache-2.0
#include "core/outline/LevelContour.h"

#include <array>
#include <cstdint>

namespace core {

namespace {

/// East, south, west, north; rows grow to the south. Turning right is one further.
constexpr std::array<glm::ivec2, 4> compass{
    glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(-1, 0), glm::ivec2(0, -1)};

class LevelPart {
public:
    /// The pixels that hang together with one by their sides, and whose codes are on the same side
    /// of its code.
    LevelPart(const SlicePixels& picture, const glm::ivec2& from, bool brighter)
        : m_picture(picture)
        , m_inside(picture.codes.size(), std::uint8_t(0))
        , m_first(from)
    {
        const int level = picture.code(from);
        std::vector<glm::ivec2> open{from};
        m_inside[at(from)] = 1;
        while (!open.empty()) {
            const glm::ivec2 pixel = open.back();
            open.pop_back();
            if (pixel.y < m_first.y || (pixel.y == m_first.y && pixel.x < m_first.x))
                m_first = pixel;
            for (const glm::ivec2& step : compass) {
                const glm::ivec2 next = pixel + step;
                if (!picture.contains(next)) {
                    m_reachesBorder = true;
                    continue;
                }
                const int code = picture.code(next);
                if (m_inside[at(next)] != 0 || (brighter ? code < level : code > level))
                    continue;
                m_inside[at(next)] = 1;
                open.push_back(next);
            }
        }
    }

    [[nodiscard]] bool reachesBorder() const { return m_reachesBorder; }

    /// Around all of it, from the upper left corner of the first pixel of its first row, with the
    /// inside at the right hand. No other pixel of it touches that corner.
    [[nodiscard]] std::vector<glm::ivec2> outerCorners() const
    {
        std::vector<glm::ivec2> corners;
        glm::ivec2 corner = m_first;
        int way = 0;
        do {
            corners.push_back(corner);
            do
                corner += compass[std::size_t(way)];
            while (goesStraightOn(corner, way));
            // Where two pixels meet by their corners alone it stays with the one it came along.
            way = isInside(aheadOnTheRight(corner, way)) ? (way + 3) % 4 : (way + 1) % 4;
        } while (corner != m_first);
        return corners;
    }

private:
    [[nodiscard]] std::size_t at(const glm::ivec2& pixel) const
    {
        return std::size_t(pixel.y) * std::size_t(m_picture.size.x) + std::size_t(pixel.x);
    }
    [[nodiscard]] bool isInside(const glm::ivec2& pixel) const
    {
        return m_picture.contains(pixel) && m_inside[at(pixel)] != 0;
    }
    /// The pixels beside the side that would follow if the way went on straight.
    [[nodiscard]] static glm::ivec2 aheadOnTheRight(const glm::ivec2& corner, int way)
    {
        constexpr std::array<glm::ivec2, 4> pixels{
            glm::ivec2(0, 0), glm::ivec2(-1, 0), glm::ivec2(-1, -1), glm::ivec2(0, -1)};
        return corner + pixels[std::size_t(way)];
    }
    [[nodiscard]] static glm::ivec2 aheadOnTheLeft(const glm::ivec2& corner, int way)
    {
        return aheadOnTheRight(corner, (way + 3) % 4);
    }
    [[nodiscard]] bool goesStraightOn(const glm::ivec2& corner, int way) const
    {
        return isInside(aheadOnTheRight(corner, way)) && !isInside(aheadOnTheLeft(corner, way));
    }

    const SlicePixels& m_picture;
    std::vector<std::uint8_t> m_inside; ///< by pixel
    glm::ivec2 m_first; ///< of its uppermost row the leftmost
    bool m_reachesBorder = false;
};

/// By the formula of the shoelace; corners with the inside at the right hand.
std::int64_t enclosed(const std::vector<glm::ivec2>& corners)
{
    std::int64_t twice = 0;
    glm::ivec2 from = corners.back();
    for (const glm::ivec2& to : corners) {
        twice += std::int64_t(from.x) * to.y - std::int64_t(to.x) * from.y;
        from = to;
    }
    return twice / 2;
}

} // namespace

LevelContour levelContour(const SlicePixels& picture, const glm::ivec2& pixel)
{
    const auto traced = [&picture, &pixel](bool brighter) {
        const LevelPart part(picture, pixel, brighter);
        LevelContour contour{.level = picture.code(pixel),
            .brighter = brighter,
            .reachesBorder = part.reachesBorder(),
            .corners = part.outerCorners()};
        contour.pixels = enclosed(contour.corners);
        return contour;
    };
    LevelContour brighter = traced(true);
    LevelContour darker = traced(false);
    if (brighter.reachesBorder != darker.reachesBorder)
        return brighter.reachesBorder ? darker : brighter;
    return darker.pixels < brighter.pixels ? darker : brighter;
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/OutlineRaster.h"

#include "core/sculpt/CutFrame.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace core {

namespace {

constexpr int unit = outlineSubdivision;
/// Twice the area of an element, in square subdivisions.
constexpr std::int64_t wholeElement = 2 * unit * unit;

int floorDivide(int value, int divisor)
{
    return value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor);
}

/// Twice the signed area to the right of the edges, per element: an edge adds what it crosses to
/// the element it crosses and the rest of its height to the next one, so that the running sum along
/// a row is the winding, weighted by area.
class SignedAreas {
public:
    /// Elements whose sums are kept together. Most of a plane is met by no edge and has none.
    static constexpr int blockLength = 32;
    using Block = std::array<std::int64_t, blockLength>; // a curve may wind any number of times

    SignedAreas(const glm::ivec2& first, const glm::ivec2& size)
        : m_origin(first * unit)
        , m_blocksPerRow(size.x / blockLength + 1) // one more element: what is right of the last
        , m_places(std::size_t(m_blocksPerRow) * std::size_t(size.y), -1)
    {
    }

    void addEdge(glm::ivec2 from, glm::ivec2 to)
    {
        from -= m_origin;
        to -= m_origin;
        const int direction = from.y < to.y ? 1 : -1;
        if (direction < 0)
            std::swap(from, to);
        const glm::ivec2 along = to - from;
        int x = from.x;
        for (int y = from.y; y < to.y;) {
            const int row = y / unit;
            const int nextY = std::min((row + 1) * unit, to.y);
            const int nextX = nextY == to.y
                ? to.x
                : from.x + int(std::int64_t(along.x) * (nextY - from.y) / along.y);
            addInRow(row, x, nextX, (nextY - y) * direction);
            x = nextX;
            y = nextY;
        }
    }

    /// Null: all 0.
    [[nodiscard]] const Block* block(int row, int number) const
    {
        const std::int32_t place = m_places[std::size_t(m_blocksPerRow * row + number)];
        return place < 0 ? nullptr : &m_blocks[std::size_t(place)];
    }

private:
    void add(int row, int element, std::int64_t twiceArea)
    {
        std::int32_t& place = m_places[std::size_t(m_blocksPerRow * row + element / blockLength)];
        if (place < 0) {
            place = std::int32_t(m_blocks.size());
            m_blocks.push_back({});
        }
        m_blocks[std::size_t(place)][std::size_t(element % blockLength)] += twiceArea;
    }

    void addInRow(int row, int fromX, int toX, int height)
    {
        if (fromX > toX)
            std::swap(fromX, toX);
        const int width = toX - fromX;
        int done = 0; // of the height
        for (int x = fromX;;) {
            const int element = x / unit;
            const int nextX = std::min((element + 1) * unit, toX);
            const int upTo =
                nextX == toX ? height : int(std::int64_t(height) * (nextX - fromX) / width);
            const int rise = upTo - done;
            const int twiceMiddle = x + nextX - 2 * element * unit;
            add(row, element, std::int64_t(rise) * (2 * unit - twiceMiddle));
            add(row, element + 1, std::int64_t(rise) * twiceMiddle);
            done = upTo;
            x = nextX;
            if (x == toX)
                break;
        }
    }

    glm::ivec2 m_origin;
    int m_blocksPerRow;
    std::vector<std::int32_t> m_places; ///< in m_blocks; below 0: none
    std::vector<Block> m_blocks;
};

std::uint16_t valueOf(std::int64_t winding)
{
    const std::int64_t covered = std::min(winding < 0 ? -winding : winding, wholeElement);
    return std::uint16_t((covered + wholeElement / 512) / (wholeElement / 256));
}

std::uint16_t blended(std::uint32_t before, std::uint32_t middle, std::uint32_t after)
{
    return std::uint16_t((43 * before + 170 * middle + 43 * after + 128) >> 8);
}

/// Of each element, the square of the distance to the nearest one that is covered by less than a
/// half, there or beyond the raster; in elements. Meijster's two passes: along columns, then the
/// lower envelope of the parabolas that the columns give along each row.
std::vector<std::int64_t> squaredDepths(const OutlineRaster& mask)
{
    const int width = mask.size.x;
    const int height = mask.size.y;
    std::vector<std::int64_t> squares(mask.values.size(), 0);
    const auto place = [width](int a, int b) {
        return std::size_t(a) + std::size_t(width) * std::size_t(b);
    };
    for (int a = 0; a < width; ++a) {
        std::int64_t run = 0;
        for (int b = 0; b < height; ++b)
            squares[place(a, b)] = run = mask.values[place(a, b)] < 128 ? 0 : run + 1;
        run = 0;
        for (int b = height - 1; b >= 0; --b) {
            run = std::min(squares[place(a, b)], run + 1);
            squares[place(a, b)] = run;
        }
    }
    struct Parabola {
        std::int64_t apex; ///< its column
        std::int64_t height; ///< there
        std::int64_t from; ///< the first column where it is the lowest
    };
    std::vector<Parabola> lowest;
    for (int b = 0; b < height; ++b) {
        // What lies beyond the raster, on both sides, is not covered.
        lowest.assign(1, {-1, 0, 0});
        for (std::int64_t a = 0; a <= width; ++a) {
            const std::int64_t rise =
                a == width ? 0 : squares[place(int(a), b)] * squares[place(int(a), b)];
            const auto at = [](const Parabola& parabola, std::int64_t x) {
                return (x - parabola.apex) * (x - parabola.apex) + parabola.height;
            };
            while (!lowest.empty()
                && at(lowest.back(), lowest.back().from) > at({a, rise, 0}, lowest.back().from))
                lowest.pop_back();
            if (lowest.empty()) {
                lowest.push_back({a, rise, 0});
                continue;
            }
            const Parabola& last = lowest.back();
            const std::int64_t from =
                1 + (a * a - last.apex * last.apex + rise - last.height) / (2 * (a - last.apex));
            if (from < width)
                lowest.push_back({a, rise, from});
        }
        std::size_t next = lowest.size();
        for (int a = width - 1; a >= 0; --a) {
            while (lowest[next - 1].from > a)
                --next;
            const Parabola& parabola = lowest[next - 1];
            squares[place(a, b)] = (a - parabola.apex) * (a - parabola.apex) + parabola.height;
        }
    }
    return squares;
}

/// From the edge, which lies half an element before the first that is not covered; in 1/256
/// elements.
std::int64_t depth256(std::int64_t square)
{
    return fixedPoint::squareRoot(square * 65536) - 128;
}

} // namespace

std::int64_t OutlineRaster::area() const
{
    return std::accumulate(values.begin(), values.end(), std::int64_t(0));
}

OutlineRaster filledExactly(const std::vector<OutlineVertex>& vertices)
{
    if (vertices.size() < 3)
        return {};
    glm::ivec2 low = vertices.front();
    glm::ivec2 high = low;
    for (const OutlineVertex& vertex : vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    OutlineRaster mask;
    mask.first = {floorDivide(low.x, unit), floorDivide(low.y, unit)};
    mask.size = glm::ivec2(floorDivide(high.x, unit), floorDivide(high.y, unit)) + 1 - mask.first;

    SignedAreas areas(mask.first, mask.size);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        areas.addEdge(vertices[i], vertices[(i + 1) % vertices.size()]);

    mask.values.resize(std::size_t(mask.size.x) * std::size_t(mask.size.y));
    for (int b = 0; b < mask.size.y; ++b) {
        std::uint16_t* const out = &mask.values[std::size_t(mask.size.x) * std::size_t(b)];
        std::int64_t winding = 0;
        for (int from = 0; from < mask.size.x; from += SignedAreas::blockLength) {
            const int length = std::min(SignedAreas::blockLength, mask.size.x - from);
            const auto* const block = areas.block(b, from / SignedAreas::blockLength);
            if (!block && winding != 0)
                std::fill_n(out + from, length, valueOf(winding));
            for (int i = 0; block && i < length; ++i) {
                winding += (*block)[std::size_t(i)];
                out[from + i] = valueOf(winding);
            }
        }
    }
    return mask;
}

OutlineRaster smoothed(const OutlineRaster& mask)
{
    if (mask.empty())
        return mask;
    OutlineRaster result;
    result.first = mask.first - 1;
    result.size = mask.size + 2;
    const auto width = std::size_t(result.size.x);
    // Rows first, with an empty element beyond both ends; then columns over three such rows.
    const std::vector<std::uint16_t> empty(width, 0);
    std::vector<std::uint16_t> along(width * std::size_t(mask.size.y));
    std::vector<std::uint16_t> padded(width + 2, 0);
    for (int b = 0; b < mask.size.y; ++b) {
        const auto row = mask.values.begin() + std::ptrdiff_t(mask.size.x) * b;
        std::copy(row, row + mask.size.x, padded.begin() + 2);
        std::uint16_t* const out = &along[width * std::size_t(b)];
        for (std::size_t a = 0; a < width; ++a)
            out[a] = blended(padded[a], padded[a + 1], padded[a + 2]);
    }
    result.values.resize(width * std::size_t(result.size.y));
    const auto rowAt = [&](int b) {
        return b < 0 || b >= mask.size.y ? empty.data() : &along[width * std::size_t(b)];
    };
    for (int b = 0; b < result.size.y; ++b) {
        const std::uint16_t* const before = rowAt(b - 2);
        const std::uint16_t* const middle = rowAt(b - 1);
        const std::uint16_t* const after = rowAt(b);
        std::uint16_t* const out = &result.values[width * std::size_t(b)];
        for (std::size_t a = 0; a < width; ++a)
            out[a] = blended(before[a], middle[a], after[a]);
    }
    return result;
}

OutlineRaster softened(const OutlineRaster& mask, std::int64_t width)
{
    const std::vector<std::int64_t> squares = squaredDepths(mask);
    std::int64_t deepest = 0;
    for (const std::int64_t square : squares)
        deepest = std::max(deepest, depth256(square));
    width = std::min(width, deepest);
    OutlineRaster result = mask;
    for (std::size_t i = 0; width > 0 && i < squares.size(); ++i) {
        const std::int64_t most = std::max<std::int64_t>(depth256(squares[i]), 0) * 256 / width;
        result.values[i] = std::uint16_t(std::min<std::int64_t>(result.values[i], most));
    }
    return result;
}

} // namespace core

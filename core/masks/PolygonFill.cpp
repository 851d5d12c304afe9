// SPDX-License-Identifier: Apache-2.0
#include "core/masks/PolygonFill.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace core {

namespace {

constexpr std::int64_t onePixel = std::int64_t(1) << SlicePolygon::bits;

std::int64_t ceilQuotient(std::int64_t number, std::int64_t by)
{
    return number >= 0 ? (number + by - 1) / by : -(-number / by);
}

/// An edge that goes up, for the rows from its lower end to below its upper one.
struct Edge {
    glm::i64vec2 low;
    glm::i64vec2 high;

    [[nodiscard]] std::int64_t firstRow() const { return ceilQuotient(low.y, onePixel); }
    [[nodiscard]] std::int64_t endRow() const { return ceilQuotient(high.y, onePixel); }
    /// The first column whose centre does not lie before the edge.
    [[nodiscard]] std::int64_t columnAt(std::int64_t row) const
    {
        const std::int64_t height = high.y - low.y;
        const std::int64_t across = (row * onePixel - low.y) * (high.x - low.x);
        return ceilQuotient(low.x * height + across, onePixel * height);
    }
};

std::vector<Edge> edgesOf(const std::vector<SlicePolygon>& polygons)
{
    std::vector<Edge> edges;
    for (const SlicePolygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.points.size(); ++i) {
            const glm::i64vec2 from(polygon.points[i]);
            const glm::i64vec2 to(polygon.points[(i + 1) % polygon.points.size()]);
            if (from.y != to.y)
                edges.push_back(from.y < to.y ? Edge{from, to} : Edge{to, from});
        }
    }
    return edges;
}

} // namespace

glm::ivec2 slicePoint(const glm::dvec2& place)
{
    const auto fixed = [](double part) {
        constexpr double farthestPixel = 65536.0;
        return int(
            std::llround(std::clamp(part, -farthestPixel, farthestPixel) * double(onePixel)));
    };
    return {fixed(place.x), fixed(place.y)};
}

void fillPolygons(const std::vector<SlicePolygon>& polygons, const glm::ivec2& size,
    const std::function<void(int row, int from, int to)>& span)
{
    std::vector<std::vector<int>> columns(std::size_t(size.y));
    for (const Edge& edge : edgesOf(polygons)) {
        const std::int64_t end = std::min<std::int64_t>(edge.endRow(), size.y);
        for (std::int64_t row = std::max<std::int64_t>(edge.firstRow(), 0); row < end; ++row) {
            const std::int64_t column = edge.columnAt(row);
            columns[std::size_t(row)].push_back(int(std::clamp<std::int64_t>(column, 0, size.x)));
        }
    }
    for (int row = 0; row < size.y; ++row) {
        std::vector<int>& crossed = columns[std::size_t(row)];
        std::sort(crossed.begin(), crossed.end());
        for (std::size_t i = 0; i + 1 < crossed.size(); i += 2) {
            if (crossed[i] < crossed[i + 1])
                span(row, crossed[i], crossed[i + 1]);
        }
    }
}

std::uint64_t surroundedPixels(const std::vector<SlicePolygon>& polygons, const glm::ivec2& size)
{
    constexpr int around = 4096;
    glm::ivec2 low(size + around);
    glm::ivec2 high(-around);
    for (const SlicePolygon& polygon : polygons) {
        for (const glm::ivec2& point : polygon.points) {
            low = glm::min(low, point >> SlicePolygon::bits);
            high = glm::max(high, (point >> SlicePolygon::bits) + 1);
        }
    }
    low = glm::max(low, glm::ivec2(-around));
    constexpr int farthestPixel = 65536; // that slicePoint() gives, and that 32 bits leave room for
    high = glm::min(high, glm::min(size + around, glm::ivec2(farthestPixel)));
    // In bands, so that many edges need no more memory than in a slice.
    constexpr int band = 512;
    std::uint64_t pixels = 0;
    for (int top = low.y; top < high.y && low.x < high.x; top += band) {
        std::vector<SlicePolygon> moved = polygons;
        for (SlicePolygon& polygon : moved) {
            for (glm::ivec2& point : polygon.points)
                point -= glm::ivec2(low.x, top) << SlicePolygon::bits;
        }
        fillPolygons(moved, {high.x - low.x, std::min(band, high.y - top)},
            [&](int, int from, int to) { pixels += std::uint64_t(to - from); });
    }
    return pixels;
}

} // namespace core

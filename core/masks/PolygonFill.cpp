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

} // namespace core

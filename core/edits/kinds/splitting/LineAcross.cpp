// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/LineAcross.h"

#include <array>
#include <cmath>

namespace core {

namespace {

double lengthOf(const glm::dvec2& v)
{
    return std::sqrt(v.x * v.x + v.y * v.y);
}

double lengthOf(const std::vector<glm::dvec2>& line)
{
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += lengthOf(line[i] - line[i - 1]);
    return length;
}

/// The place on a line that one reaches from its beginning after a length.
template <class Points> glm::dvec2 placeAfter(double length, const Points& first, const Points& end)
{
    for (auto next = first + 1; next != end; ++next) {
        const glm::dvec2 from = *(next - 1);
        const double piece = lengthOf(*next - from);
        if (piece >= length)
            return piece > 0.0 ? from + (*next - from) * (length / piece) : from;
        length -= piece;
    }
    return *(end - 1);
}

/// Where one leaves a rectangle who goes from a place within it in a direction.
struct Exit {
    glm::dvec2 place{0.0};
    double way = 0.0; ///< along the border, counterclockwise from `low`: 1 for each side
};

Exit exitOf(const glm::dvec2& from, const glm::dvec2& direction, const glm::dvec2& low,
    const glm::dvec2& high)
{
    // The sides counterclockwise: the lower, the right, the upper and the left one.
    const bool leavesRight = direction.x > 0.0;
    const bool leavesAbove = direction.y > 0.0;
    const double x = leavesRight ? high.x : low.x;
    const double y = leavesAbove ? high.y : low.y;
    const glm::dvec2 size = high - low;
    const double toX = direction.x != 0.0 ? (x - from.x) / direction.x : INFINITY;
    const double toY = direction.y != 0.0 ? (y - from.y) / direction.y : INFINITY;
    if (toX <= toY) {
        const glm::dvec2 place(x, from.y + toX * direction.y);
        const double up = (place.y - low.y) / size.y;
        return {place, leavesRight ? 1.0 + up : 4.0 - up};
    }
    const glm::dvec2 place(from.x + toY * direction.x, y);
    const double right = (place.x - low.x) / size.x;
    return {place, leavesAbove ? 3.0 - right : right};
}

} // namespace

std::optional<LineEnds> lineEnds(const std::vector<glm::dvec2>& line)
{
    const double tenth = lengthOf(line) / 10.0;
    if (!(tenth > 0.0))
        return std::nullopt;
    const glm::dvec2 before = line.front() - placeAfter(tenth, line.begin(), line.end());
    const glm::dvec2 behind = line.back() - placeAfter(tenth, line.rbegin(), line.rend());
    if (!(lengthOf(before) > 0.0) || !(lengthOf(behind) > 0.0))
        return std::nullopt;
    return LineEnds{before / lengthOf(before), behind / lengthOf(behind)};
}

std::vector<glm::dvec2> leftOfLine(
    const std::vector<glm::dvec2>& line, const glm::dvec2& low, const glm::dvec2& high)
{
    const std::optional<LineEnds> ends = lineEnds(line);
    if (!ends)
        return {};
    const Exit begin = exitOf(line.front(), ends->before, low, high);
    const Exit end = exitOf(line.back(), ends->behind, low, high);
    std::vector<glm::dvec2> curve{begin.place};
    curve.insert(curve.end(), line.begin(), line.end());
    curve.push_back(end.place);
    const std::array<glm::dvec2, 4> corners{
        low, glm::dvec2(high.x, low.y), high, glm::dvec2(low.x, high.y)};
    const double last = begin.way > end.way ? begin.way : begin.way + 4.0;
    for (int corner = int(std::floor(end.way)) + 1; corner < last; ++corner)
        curve.push_back(corners[std::size_t(corner % 4)]);
    return curve;
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/outline/SegmentAxes.h"

#include "core/volume/UnevenSlices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace core {

namespace {

/// What hangs together with a pixel, at sides or corners.
std::vector<glm::ivec2> hangingTogether(
    const glm::ivec2& size, const std::vector<std::uint8_t>& inside, const glm::ivec2& pixel)
{
    const auto at = [&size](const glm::ivec2& place) {
        return std::size_t(place.y) * std::size_t(size.x) + std::size_t(place.x);
    };
    std::vector<bool> seen(inside.size(), false);
    std::vector<glm::ivec2> found{pixel};
    seen[at(pixel)] = true;
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const glm::ivec2 next = found[i] + glm::ivec2(dx, dy);
                if (next.x < 0 || next.y < 0 || next.x >= size.x || next.y >= size.y)
                    continue;
                if (inside[at(next)] == 0 || seen[at(next)])
                    continue;
                seen[at(next)] = true;
                found.push_back(next);
            }
        }
    }
    return found;
}

double turnOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners of the convex hull, counter-clockwise (the monotone chain).
std::vector<glm::dvec2> hullOf(std::vector<glm::dvec2> places)
{
    std::sort(places.begin(), places.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    std::vector<glm::dvec2> hull;
    const auto chain = [&hull](const glm::dvec2& place, std::size_t kept) {
        while (hull.size() > kept && turnOf(hull[hull.size() - 2], hull.back(), place) <= 0.0)
            hull.pop_back();
        hull.push_back(place);
    };
    for (const glm::dvec2& place : places)
        chain(place, 1);
    const std::size_t lower = hull.size();
    for (auto place = places.rbegin() + 1; place != places.rend(); ++place)
        chain(*place, lower);
    hull.pop_back(); // the first one again
    return hull;
}

/// Where a line across `along` through a place meets the hull: the lowest and the highest place.
std::pair<glm::dvec2, glm::dvec2> chordAt(
    const std::vector<glm::dvec2>& hull, const glm::dvec2& along, double place)
{
    const glm::dvec2 across(-along.y, along.x);
    std::pair<glm::dvec2, glm::dvec2> chord{hull.front(), hull.front()};
    bool any = false;
    const auto meet = [&](const glm::dvec2& at) {
        if (!any || glm::dot(at, across) < glm::dot(chord.first, across))
            chord.first = at;
        if (!any || glm::dot(at, across) > glm::dot(chord.second, across))
            chord.second = at;
        any = true;
    };
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2& from = hull[i];
        const glm::dvec2& to = hull[(i + 1) % hull.size()];
        const double here = glm::dot(from, along) - place;
        const double there = glm::dot(to, along) - place;
        if (here == 0.0)
            meet(from);
        else if ((here < 0.0) != (there < 0.0))
            meet(from + (to - from) * (here / (here - there)));
    }
    return chord;
}

/// Chords of a convex hull are longest at one of its corners.
std::pair<glm::dvec2, glm::dvec2> widestChord(
    const std::vector<glm::dvec2>& hull, const glm::dvec2& along)
{
    std::pair<glm::dvec2, glm::dvec2> widest{hull.front(), hull.front()};
    for (const glm::dvec2& corner : hull) {
        const auto chord = chordAt(hull, along, glm::dot(corner, along));
        if (glm::distance(chord.first, chord.second) > glm::distance(widest.first, widest.second))
            widest = chord;
    }
    return widest;
}

/// The midpoints of a pixel's sides, in pixels.
std::array<glm::dvec2, 4> sidesOf(const glm::ivec2& pixel)
{
    const glm::dvec2 middle(pixel);
    return {glm::dvec2(middle.x - 0.5, middle.y), glm::dvec2(middle.x + 0.5, middle.y),
        glm::dvec2(middle.x, middle.y - 0.5), glm::dvec2(middle.x, middle.y + 0.5)};
}

/// Where the pixels of a slice truly lie in a volume whose slices are unevenly spaced. In the gap
/// between two of them they lie evenly; the outermost gaps go on beyond.
class TrueSlice {
public:
    TrueSlice(const SliceLattice& lattice, const VolumeGeometry& geometry)
        : m_geometry(geometry)
        , m_origin(geometry.toIndex(lattice.originLps))
        , m_column(glm::dmat3(geometry.worldToIndex()) * lattice.columnLps)
        , m_row(glm::dmat3(geometry.worldToIndex()) * lattice.rowLps)
        , m_gaps(std::max(1, int(geometry.slicePositions.size()) - 1))
    {
    }

    [[nodiscard]] glm::dvec3 placeOf(const glm::dvec2& pixel) const
    {
        return worldBetweenSlices(m_geometry, indexOf(pixel));
    }
    [[nodiscard]] int gapOf(const glm::dvec2& pixel) const
    {
        return std::clamp(int(std::floor(indexOf(pixel).z)), 0, m_gaps - 1);
    }
    /// What lies so far along two directions, mm from a place.
    /// @param directions unit vectors
    [[nodiscard]] glm::dvec2 pixelAt(const glm::dvec3& fromLps,
        const std::pair<glm::dvec3, glm::dvec3>& directions, const glm::dvec2& wayMm) const
    {
        const auto along = [&directions](const glm::dvec3& way) {
            return glm::dvec2(glm::dot(way, directions.first), glm::dot(way, directions.second));
        };
        glm::dvec2 found(0.0);
        double nearest = std::numeric_limits<double>::max();
        for (int gap = 0; gap < m_gaps; ++gap) {
            // As if all lay as it does in this gap; right is the one in which the pixel is then.
            const glm::dvec3 below = worldBetweenSlices(m_geometry, {0.0, 0.0, double(gap)});
            const glm::dvec3 middle = worldBetweenSlices(m_geometry, {0.0, 0.0, gap + 0.5});
            glm::dmat3 steps(m_geometry.indexToWorld);
            steps[2] = 2.0 * (middle - below);
            const glm::dvec3 first = below + steps * (m_origin - glm::dvec3(0.0, 0.0, gap));
            const glm::dmat2 ways(along(steps * m_column), along(steps * m_row));
            if (glm::determinant(ways) == 0.0)
                continue;
            const glm::dvec2 pixel = glm::inverse(ways) * (wayMm - along(first - fromLps));
            const double height = indexOf(pixel).z - gap;
            const double beyond =
                std::max(gap > 0 ? -height : 0.0, gap + 1 < m_gaps ? height - 1.0 : 0.0);
            if (beyond >= nearest)
                continue;
            nearest = beyond;
            found = pixel;
        }
        return found;
    }

private:
    [[nodiscard]] glm::dvec3 indexOf(const glm::dvec2& pixel) const
    {
        return m_origin + pixel.x * m_column + pixel.y * m_row;
    }

    const VolumeGeometry& m_geometry;
    glm::dvec3 m_origin; ///< in indices, as both steps between pixels
    glm::dvec3 m_column;
    glm::dvec3 m_row;
    int m_gaps;
};

/// The axes of pixels whose true places are not those that the slice shows.
SegmentAxes trueAxes(const SliceLattice& lattice, const VolumeGeometry& geometry,
    const std::vector<glm::ivec2>& pixels)
{
    const TrueSlice slice(lattice, geometry);
    // Only a corner of what lies in its gap can be an end. In an oblique slice the true places lie
    // in a plane for each gap, and not in one.
    std::map<int, std::vector<glm::dvec2>> ofGaps;
    for (const glm::ivec2& pixel : pixels) {
        for (const glm::dvec2& side : sidesOf(pixel))
            ofGaps[slice.gapOf(side)].push_back(side);
    }
    std::vector<glm::dvec2> corners;
    for (auto& [gap, places] : ofGaps) {
        const std::vector<glm::dvec2> hull = places.size() < 2 ? places : hullOf(std::move(places));
        corners.insert(corners.end(), hull.begin(), hull.end());
    }
    std::vector<glm::dvec3> places;
    for (const glm::dvec2& corner : corners)
        places.push_back(slice.placeOf(corner));
    double longest = 0.0;
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t k = i + 1; k < places.size(); ++k) {
            if (glm::distance(places[i], places[k]) <= longest)
                continue;
            longest = glm::distance(places[i], places[k]);
            from = i;
            to = k;
        }
    }
    const glm::dvec3 along = glm::normalize(places[to] - places[from]);
    const glm::dvec3 across =
        glm::normalize(glm::cross(glm::cross(lattice.columnLps, lattice.rowLps), along));
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& place : places) {
        const glm::dvec3 way = place - places[from];
        flat.emplace_back(glm::dot(way, along), glm::dot(way, across));
    }
    const auto widest = widestChord(hullOf(std::move(flat)), {1.0, 0.0});
    const auto shown = [&lattice](const glm::dvec2& pixel) {
        return lattice.originLps + pixel.x * lattice.columnLps + pixel.y * lattice.rowLps;
    };
    const auto shownAt = [&](const glm::dvec2& wayMm) {
        return shown(slice.pixelAt(places[from], {along, across}, wayMm));
    };
    return {.longFromLps = shown(corners[from]),
        .longToLps = shown(corners[to]),
        .shortFromLps = shownAt(widest.first),
        .shortToLps = shownAt(widest.second)};
}

} // namespace

std::optional<SegmentAxes> segmentAxes(const SliceLattice& lattice, const VolumeGeometry& geometry,
    const std::vector<std::uint8_t>& inside, const glm::ivec2& pixel)
{
    const glm::ivec2 size = lattice.size;
    const bool isThere = pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.x && pixel.y < size.y
        && inside.size() == std::size_t(size.x) * std::size_t(size.y);
    if (!isThere || inside[std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x)] == 0)
        return std::nullopt;
    const std::vector<glm::ivec2> pixels = hangingTogether(size, inside, pixel);
    if (!geometry.slicePositions.empty())
        return trueAxes(lattice, geometry, pixels);
    // In the plane of the slice, whose columns and rows need not be perpendicular.
    const glm::dvec3 right = glm::normalize(lattice.columnLps);
    const glm::dvec3 down =
        glm::normalize(lattice.rowLps - glm::dot(lattice.rowLps, right) * right);
    const auto inPlane = [&](double x, double y) {
        const glm::dvec3 way = x * lattice.columnLps + y * lattice.rowLps;
        return glm::dvec2(glm::dot(way, right), glm::dot(way, down));
    };
    const auto inPatient = [&](const glm::dvec2& place) {
        return lattice.originLps + place.x * right + place.y * down;
    };
    std::vector<glm::dvec2> places;
    for (const glm::ivec2& each : pixels) {
        for (const glm::dvec2& side : sidesOf(each))
            places.push_back(inPlane(side.x, side.y));
    }
    const std::vector<glm::dvec2> hull = hullOf(std::move(places));
    double longest = 0.0;
    glm::dvec2 from(0.0);
    glm::dvec2 to(0.0);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        for (std::size_t k = i + 1; k < hull.size(); ++k) {
            if (glm::distance(hull[i], hull[k]) <= longest)
                continue;
            longest = glm::distance(hull[i], hull[k]);
            from = hull[i];
            to = hull[k];
        }
    }
    const auto widest = widestChord(hull, glm::normalize(to - from));
    return SegmentAxes{.longFromLps = inPatient(from),
        .longToLps = inPatient(to),
        .shortFromLps = inPatient(widest.first),
        .shortToLps = inPatient(widest.second)};
}

} // namespace core

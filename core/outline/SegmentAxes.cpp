// SPDX-License-Identifier: Apache-2.0
#include "core/outline/SegmentAxes.h"

#include <algorithm>
#include <cmath>

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

} // namespace

std::optional<SegmentAxes> segmentAxes(
    const SliceLattice& lattice, const std::vector<std::uint8_t>& inside, const glm::ivec2& pixel)
{
    const glm::ivec2 size = lattice.size;
    const bool isThere = pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.x && pixel.y < size.y
        && inside.size() == std::size_t(size.x) * std::size_t(size.y);
    if (!isThere || inside[std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x)] == 0)
        return std::nullopt;
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
    for (const glm::ivec2& each : hangingTogether(size, inside, pixel)) {
        places.push_back(inPlane(each.x - 0.5, each.y));
        places.push_back(inPlane(each.x + 0.5, each.y));
        places.push_back(inPlane(each.x, each.y - 0.5));
        places.push_back(inPlane(each.x, each.y + 0.5));
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
    // Chords of a convex hull are longest at one of its corners.
    const glm::dvec2 along = glm::normalize(to - from);
    std::pair<glm::dvec2, glm::dvec2> widest{from, from};
    for (const glm::dvec2& corner : hull) {
        const auto chord = chordAt(hull, along, glm::dot(corner, along));
        if (glm::distance(chord.first, chord.second) > glm::distance(widest.first, widest.second))
            widest = chord;
    }
    return SegmentAxes{.longFromLps = inPatient(from),
        .longToLps = inPatient(to),
        .shortFromLps = inPatient(widest.first),
        .shortToLps = inPatient(widest.second)};
}

} // namespace core

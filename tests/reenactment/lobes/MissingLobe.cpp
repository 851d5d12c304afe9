// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/lobes/MissingLobe.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace reenact {

namespace {

constexpr double gridMm = 1.0;
/// How far beyond the cut an open contour begins.
constexpr double overlapMm = 3.0;
/// Over which the trembling is alike.
constexpr double trembleMm = 4.0;

using Line = std::vector<glm::dvec3>;

glm::dvec3 axisBeside(const glm::dvec3& normal)
{
    const glm::dvec3 slant = glm::abs(normal);
    const glm::dvec3 axis = slant.x <= slant.y && slant.x <= slant.z ? glm::dvec3(1, 0, 0)
        : slant.y <= slant.z                                         ? glm::dvec3(0, 1, 0)
                                                                     : glm::dvec3(0, 0, 1);
    return glm::normalize(axis - glm::dot(axis, normal) * normal);
}

/// Where the voxels that are missing lie along a direction, ascending.
std::vector<double> placesAlong(const MissingLobe& lobe, const glm::dvec3& direction)
{
    std::vector<double> places;
    std::size_t at = 0;
    for (int z = 0; z < lobe.truth.size.z; ++z) {
        for (int y = 0; y < lobe.truth.size.y; ++y) {
            for (int x = 0; x < lobe.truth.size.x; ++x, ++at) {
                if (lobe.truth.values[at] != lobe.left.values[at])
                    places.push_back(
                        glm::dot(lobe.geometry.toWorld(glm::dvec3(x, y, z)), direction));
            }
        }
    }
    std::sort(places.begin(), places.end());
    return places;
}

/// The outlines of the organ on a plane.
class PlaneOutlines {
public:
    PlaneOutlines(const MissingLobe& lobe, const Field& soft, const glm::dvec3& normal, double atMm)
        : m_lobe(lobe)
        , m_soft(soft)
        , m_right(axisBeside(normal))
        , m_down(glm::cross(normal, m_right))
    {
        const glm::dvec3 size(lobe.geometry.size);
        const glm::dvec3 middle = lobe.geometry.toWorld(0.5 * (size - 1.0));
        m_origin = middle + (atMm - glm::dot(middle, normal)) * normal;
        const double extentMm =
            glm::distance(lobe.geometry.toWorld(glm::dvec3(0.0)), lobe.geometry.toWorld(size));
        m_half = int(0.5 * extentMm / gridMm) + 2;
    }

    [[nodiscard]] std::vector<Line> all()
    {
        const int count = 2 * m_half + 1;
        std::vector<double> values;
        for (int j = 0; j < count; ++j) {
            for (int i = 0; i < count; ++i)
                values.push_back(valueAt(placeOf(i, j)));
        }
        const auto valueOf = [&](int i, int j) { return values[std::size_t(j * count + i)]; };
        // A border of a cell is named by its first corner, and whether it runs right or down.
        const auto crossing = [&](int i, int j, bool isDown) {
            const double one = valueOf(i, j);
            const double other = isDown ? valueOf(i, j + 1) : valueOf(i + 1, j);
            const int name = 2 * (j * count + i) + (isDown ? 1 : 0);
            if ((one > 0.0) == (other > 0.0))
                return -1;
            const double share = one / (one - other);
            const glm::dvec3 from = placeOf(i, j);
            const glm::dvec3 to = isDown ? placeOf(i, j + 1) : placeOf(i + 1, j);
            m_places[name] = from + share * (to - from);
            return name;
        };
        for (int j = 0; j + 1 < count; ++j) {
            for (int i = 0; i + 1 < count; ++i) {
                std::vector<int> around;
                for (const int name : {crossing(i, j, false), crossing(i + 1, j, true),
                         crossing(i, j + 1, false), crossing(i, j, true)}) {
                    if (name >= 0)
                        around.push_back(name);
                }
                for (std::size_t pair = 0; pair + 1 < around.size(); pair += 2) {
                    m_next[around[pair]].push_back(around[pair + 1]);
                    m_next[around[pair + 1]].push_back(around[pair]);
                }
            }
        }
        return chained();
    }

private:
    [[nodiscard]] glm::dvec3 placeOf(int i, int j) const
    {
        return m_origin + gridMm * (double(i - m_half) * m_right + double(j - m_half) * m_down);
    }

    /// Positive inside; what lies off the grid is outside.
    [[nodiscard]] double valueAt(const glm::dvec3& place) const
    {
        const glm::dvec3 index = m_lobe.geometry.toIndex(place);
        for (int axis = 0; axis < 3; ++axis) {
            if (index[axis] < -0.5 || index[axis] > double(m_lobe.geometry.size[axis]) - 0.5)
                return -0.5;
        }
        return sampled(m_soft, index) - 0.5;
    }

    /// All of them close, since the grid ends outside.
    [[nodiscard]] std::vector<Line> chained()
    {
        std::vector<Line> lines;
        while (!m_next.empty()) {
            Line line;
            int here = m_next.begin()->first;
            for (auto found = m_next.find(here); found != m_next.end(); found = m_next.find(here)) {
                line.push_back(m_places[here]);
                const std::vector<int> next = found->second;
                m_next.erase(found);
                for (const int name : next) {
                    if (m_next.contains(name))
                        here = name;
                }
            }
            lines.push_back(std::move(line));
        }
        return lines;
    }

    const MissingLobe& m_lobe;
    const Field& m_soft;
    glm::dvec3 m_right;
    glm::dvec3 m_down;
    glm::dvec3 m_origin{0.0};
    int m_half = 0;
    std::map<int, glm::dvec3> m_places;
    std::map<int, std::vector<int>> m_next;
};

/// The longest part of an outline that a hand would draw.
core::TemplateContour inLobe(const MissingLobe& lobe, const Line& line)
{
    const auto isThere = [&](std::size_t i) {
        return glm::dot(line[i % line.size()], lobe.normalLps) > lobe.atMm - overlapMm;
    };
    std::size_t outside = 0;
    while (outside < line.size() && isThere(outside))
        ++outside;
    if (outside == line.size())
        return {.pointsLps = line, .isClosed = true};
    core::TemplateContour longest;
    Line run;
    for (std::size_t i = outside; i <= outside + line.size(); ++i) {
        if (isThere(i)) {
            run.push_back(line[i % line.size()]);
            continue;
        }
        if (run.size() > longest.pointsLps.size())
            longest.pointsLps = run;
        run.clear();
    }
    return longest;
}

} // namespace

void tremble(core::TemplateContour& contour, const glm::dvec3& normal, double stepMm,
    double jitterMm, CounterRandom& random)
{
    const glm::dvec3 right = axisBeside(normal);
    const glm::dvec3 down = glm::cross(normal, right);
    const int count = int(contour.pointsLps.size());
    const int reach = int(3.0 * trembleMm / stepMm);
    std::vector<double> weights;
    double squares = 0.0;
    for (int off = -reach; off <= reach; ++off) {
        const double away = double(off) * stepMm / trembleMm;
        weights.push_back(std::exp(-0.5 * away * away));
        squares += weights.back() * weights.back();
    }
    std::vector<glm::dvec2> noise(std::size_t(count + 2 * reach));
    for (glm::dvec2& each : noise)
        each = {random.normal(), random.normal()};
    for (int i = 0; i < count; ++i) {
        glm::dvec2 sum(0.0);
        for (int off = -reach; off <= reach; ++off) {
            // A closed one closes after it trembled, too.
            const int from = contour.isClosed ? (i + off + reach * count) % count : i + off + reach;
            sum += weights[std::size_t(off + reach)] * noise[std::size_t(from)];
        }
        sum *= jitterMm / std::sqrt(squares);
        contour.pointsLps[std::size_t(i)] += sum.x * right + sum.y * down;
    }
}

MissingLobe withoutLobe(const core::VolumeGeometry& geometry, const Mask& truth,
    const glm::dvec3& normalLps, double share)
{
    MissingLobe lobe{.geometry = geometry,
        .truth = truth,
        .left = {truth.size, std::vector<std::uint8_t>(truth.values.size(), 0)},
        .normalLps = glm::normalize(normalLps)};
    const std::vector<double> places = placesAlong(lobe, lobe.normalLps);
    lobe.atMm = places[std::size_t((1.0 - share) * double(places.size()))];
    std::size_t at = 0;
    for (int z = 0; z < truth.size.z; ++z) {
        for (int y = 0; y < truth.size.y; ++y) {
            for (int x = 0; x < truth.size.x; ++x, ++at) {
                if (glm::dot(geometry.toWorld(glm::dvec3(x, y, z)), lobe.normalLps) < lobe.atMm)
                    lobe.left.values[at] = truth.values[at];
            }
        }
    }
    return lobe;
}

std::vector<core::TemplateContour> drawn(
    const MissingLobe& lobe, const LobeDrawing& drawing, double jitterMm, std::uint64_t seed)
{
    const Field soft = smoothed(lobe.truth);
    const glm::dvec3 upright = axisBeside(lobe.normalLps);
    const glm::dvec3 beside = glm::cross(lobe.normalLps, upright);
    CounterRandom random(seed, 34);
    std::vector<core::TemplateContour> contours;
    for (const auto& [normal, count] : {std::pair(lobe.normalLps, drawing.across),
             std::pair(upright, drawing.upright), std::pair(beside, drawing.beside)}) {
        const std::vector<double> places = placesAlong(lobe, normal);
        for (int i = 0; i < count; ++i) {
            const double share = (double(i) + 0.5) / double(count);
            const double atMm = places[std::size_t(share * double(places.size()))];
            core::TemplateContour chosen;
            for (const Line& line : PlaneOutlines(lobe, soft, normal, atMm).all()) {
                core::TemplateContour contour = inLobe(lobe, line);
                if (contour.pointsLps.size() > chosen.pointsLps.size())
                    chosen = std::move(contour);
            }
            if (chosen.pointsLps.size() < 6)
                continue;
            if (jitterMm > 0.0)
                tremble(chosen, normal, gridMm, jitterMm, random);
            contours.push_back(std::move(chosen));
        }
    }
    return contours;
}

} // namespace reenact

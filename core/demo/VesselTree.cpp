// SPDX-License-Identifier: Apache-2.0
#include "core/demo/VesselTree.h"

#include "core/demo/HeadShapes.h"
#include "core/demo/Noise.h"
#include "core/demo/Shapes.h"

#include <array>

namespace core::demo {

namespace {

constexpr float cellMm = 8.0F;
const vec3 gridOrigin(-120.0F, -120.0F, -112.0F);
const glm::ivec3 gridSize(30, 30, 28);

int cellIndex(const glm::ivec3& cell)
{
    return cell.x + gridSize.x * (cell.y + gridSize.y * cell.z);
}

vec3 outward(const vec3& p)
{
    const float h = 0.5F;
    return glm::normalize(vec3(cranialCavity(p + vec3(h, 0, 0)) - cranialCavity(p - vec3(h, 0, 0)),
        cranialCavity(p + vec3(0, h, 0)) - cranialCavity(p - vec3(0, h, 0)),
        cranialCavity(p + vec3(0, 0, h)) - cranialCavity(p - vec3(0, 0, h))));
}

/// Moves @p p to @p depth below the inner surface of the skull.
vec3 settled(vec3 p, float depth)
{
    for (int i = 0; i < 4; ++i)
        p -= outward(p) * (cranialCavity(p) + depth);
    return p;
}

vec3 mirrored(const vec3& p)
{
    return {-p.x, p.y, p.z};
}

} // namespace

VesselTree::VesselTree()
{
    addArteries();
    addVeins();
    addSuperiorSagittalSinus();
    sortIntoCells();
}

void VesselTree::curve(std::span<const vec3> points, float radiusFrom, float radiusTo, bool mirror)
{
    // Catmull-Rom through the points.
    constexpr int pieces = 5;
    const auto last = static_cast<int>(points.size()) - 1;
    const auto at = [&](int i) { return points[static_cast<std::size_t>(std::clamp(i, 0, last))]; };
    const auto radius = [&](float t) {
        return mix(radiusFrom, radiusTo, t / static_cast<float>(last));
    };
    vec3 previous = points.front();
    float previousT = 0.0F;
    for (int i = 0; i < last; ++i) {
        for (int piece = 1; piece <= pieces; ++piece) {
            const float s = static_cast<float>(piece) / pieces;
            const vec3 a = at(i - 1);
            const vec3 b = at(i);
            const vec3 c = at(i + 1);
            const vec3 d = at(i + 2);
            const vec3 next = 0.5F
                * (2.0F * b + (c - a) * s + (2.0F * a - 5.0F * b + 4.0F * c - d) * s * s
                    + (3.0F * b - a - 3.0F * c + d) * s * s * s);
            const float t = static_cast<float>(i) + s;
            m_segments.push_back({previous, next, radius(previousT), radius(t)});
            if (mirror)
                m_segments.push_back(
                    {mirrored(previous), mirrored(next), radius(previousT), radius(t)});
            previous = next;
            previousT = t;
        }
    }
}

void VesselTree::walk(
    vec3 at, vec3 heading, float radius, float lengthMm, int generation, std::uint32_t seed)
{
    constexpr float stepMm = 3.5F;
    at = settled(at, 2.2F);
    const int steps = static_cast<int>(lengthMm / stepMm);
    const float end = std::max(0.55F, radius * 0.55F);
    int sinceBranch = 0;
    for (int step = 0; step < steps; ++step) {
        const std::uint32_t word = hash(static_cast<std::int32_t>(seed), step, generation);
        const vec3 normal = outward(at);
        const vec3 side = glm::cross(normal, heading);
        heading += side * 0.45F * uniform(word);
        heading = glm::normalize(heading - normal * glm::dot(heading, normal));
        const vec3 next = settled(at + heading * stepMm, 2.2F);
        const float t = static_cast<float>(step) / static_cast<float>(steps);
        m_segments.push_back({at, next, mix(radius, end, t),
            mix(radius, end, t + 1.0F / static_cast<float>(steps))});
        at = next;
        ++sinceBranch;
        if (generation < 2 && sinceBranch > 3 && (word & 3U) == 0U) {
            sinceBranch = 0;
            const float turn = (word & 4U) != 0U ? 0.9F : -0.9F;
            walk(at, glm::normalize(heading + side * turn), mix(radius, end, t) * 0.78F,
                lengthMm * (1.0F - t) * 0.75F, generation + 1, word);
        }
    }
}

void VesselTree::addArteries()
{
    using Points = std::vector<vec3>;
    // Internal carotid: neck, petrous and cavernous parts, siphon.
    curve(
        Points{{27, 4, -125}, {27, 2, -95}, {25, 6, -62}, {25, 5, -38}, {23, 3, -27}, {15, -5, -23},
            {10.5F, -10, -18}, {10, -20, -13}, {9.5F, -25, -8}, {9.5F, -21, -3}, {12, -17, 0}},
        2.9F, 2.2F, true);
    // Middle cerebral with the two trunks in the Sylvian fissure.
    curve(Points{{12, -17, 0}, {20, -18, 1}, {29, -17, -1}, {36, -15, 1}}, 1.9F, 1.6F, true);
    curve(Points{{36, -15, 1}, {37, -8, 6}, {38, 2, 9}, {46, 10, 12}, {57, 16, 16}}, 1.5F, 1.2F,
        true);
    curve(Points{{36, -15, 1}, {38, -18, 2}, {46, -20, 0}, {56, -18, 2}}, 1.4F, 1.1F, true);
    // Anterior cerebral around the corpus callosum.
    curve(Points{{12, -17, 0}, {7, -22, 1}, {2.2F, -27, 2}, {1.8F, -38, 8}, {1.6F, -41, 18},
              {1.6F, -32, 34}, {1.6F, -12, 41}, {1.6F, 14, 42}, {1.6F, 34, 38}},
        1.6F, 0.9F, true);
    curve(Points{{-2.2F, -27, 2}, {0, -27.5F, 2.2F}, {2.2F, -27, 2}}, 1.0F, 1.0F, false);
    curve(Points{{1.6F, -40, 22}, {1.8F, -52, 34}, {2, -58, 52}}, 1.1F, 0.8F, true);
    curve(Points{{1.6F, -22, 39}, {2, -26, 54}, {2.4F, -24, 70}}, 1.0F, 0.8F, true);
    curve(Points{{1.6F, 14, 42}, {2, 22, 54}, {2.4F, 26, 68}}, 1.0F, 0.8F, true);
    // Vertebral and basilar arteries, posterior cerebral, cerebellar and communicating arteries.
    curve(Points{{19, 12, -125}, {19, 13, -90}, {20, 14, -66}, {26, 18, -56}, {18, 26, -48},
              {9, 16, -40}, {3, 1, -33}, {0, -4, -28}},
        1.9F, 1.6F, true);
    curve(Points{{0, -4, -28}, {0, -5.5F, -18}, {0, -5, -8}, {0, -6, -4}}, 2.0F, 1.8F, false);
    curve(Points{{0, -6, -4}, {6, -6, -2}, {14, 1, 0}, {18, 14, 3}, {19, 26, 6}, {15, 40, 11},
              {12, 58, 13}},
        1.6F, 0.9F, true);
    curve(Points{{0, -5, -7}, {8, -5, -8}, {18, 8, -5}, {17, 22, -1}}, 1.0F, 0.7F, true);
    curve(Points{{0, -5, -24}, {12, 0, -25}, {24, 16, -30}, {32, 30, -36}}, 0.9F, 0.7F, true);
    curve(Points{{11, -18, -3}, {10, -10, -2}, {8, -5, -2}}, 0.9F, 0.9F, true);
    // Branches over the brain. Each side has its own.
    std::uint32_t seed = 1;
    for (const float side : {1.0F, -1.0F}) {
        const auto start = [&](vec3 at, vec3 heading, float radius, float length) {
            walk(at * vec3(side, 1, 1), heading * vec3(side, 1, 1), radius, length, 0, seed++);
        };
        start({57, -18, 3}, {0, -0.6F, 1}, 1.2F, 80);
        start({59, -6, 9}, {0, -0.2F, 1}, 1.2F, 90);
        start({60, 6, 12}, {0, 0.3F, 1}, 1.2F, 90);
        start({58, 17, 17}, {0, 1, 0.7F}, 1.2F, 85);
        start({58, 14, 14}, {0, 1, -0.1F}, 1.1F, 75);
        start({57, -14, 0}, {0, 0.6F, -1}, 1.0F, 50);
        start({2.4F, -58, 52}, {0.4F, -0.3F, 1}, 0.9F, 45);
        start({2.4F, -24, 74}, {1, -0.1F, 0.1F}, 0.9F, 50);
        start({2.4F, 26, 72}, {1, 0.3F, 0}, 0.9F, 50);
        start({12, 66, 12}, {0.5F, 0.6F, 0.5F}, 0.9F, 50);
        start({32, 34, -38}, {0.6F, 1, 0}, 0.8F, 40);
    }
}

void VesselTree::addVeins()
{
    using Points = std::vector<vec3>;
    // Deep veins and the straight sinus.
    curve(Points{{2, -6, 19}, {2, 8, 20}, {1.5F, 20, 17}}, 0.9F, 1.1F, true);
    curve(Points{{0, 20, 17}, {0, 27, 13}, {0, 33, 12}}, 1.8F, 2.0F, false);
    curve(Points{{0, 33, 12}, {0, 55, 5}, {0, 79, -2}}, 1.9F, 2.3F, false);
    // Transverse and sigmoid sinuses follow the bone; the right one is larger.
    for (const float side : {1.0F, -1.0F}) {
        std::vector<vec3> points;
        for (const vec3 p :
            {vec3(2, 82, -3), vec3(22, 74, -5), vec3(40, 56, -9), vec3(52, 38, -14)})
            points.push_back(settled(p * vec3(side, 1, 1), 2.4F));
        for (const vec3 p : {vec3(47, 27, -26), vec3(38, 24, -38)})
            points.push_back(settled(p * vec3(side, 1, 1), 2.0F));
        points.push_back({side * 30, 22, -44});
        points.push_back({side * 31, 14, -70});
        points.push_back({side * 33, 10, -125});
        const float radius = side > 0 ? 2.5F : 3.4F;
        curve(points, radius, radius + 1.4F, false);
    }
    std::uint32_t seed = 100;
    for (const float side : {1.0F, -1.0F}) {
        for (const float y : {-50.0F, -32.0F, -14.0F, 4.0F, 24.0F, 44.0F, 62.0F}) {
            const float height =
                29.0F + 52.0F * std::sqrt(std::max(0.05F, 1.0F - (y - 4) * (y - 4) / 6724.0F));
            walk({side * 4.0F, y, height}, {side, -0.35F, -0.4F}, 1.35F, 55, 1, seed++);
        }
    }
    // Superficial temporal arteries in the scalp.
    const auto inScalp = [](const vec3& p) { return settled(p, -skullThickness(p) - 3.2F); };
    curve(Points{inScalp({70, 2, 6}), inScalp({70, -6, 24}), inScalp({62, -26, 44})}, 1.2F, 0.8F,
        true);
    curve(Points{inScalp({70, 2, 6}), inScalp({70, 10, 28}), inScalp({58, 18, 58})}, 1.1F, 0.8F,
        true);
}

void VesselTree::addSuperiorSagittalSinus()
{
    const vec3 centre(0, 4, 20);
    vec3 previous(0);
    constexpr int steps = 44;
    for (int step = 0; step <= steps; ++step) {
        const float t = static_cast<float>(step) / steps;
        const float angle =
            mix(-0.95F, 1.84F, t); // from the forehead over the vertex to the torcula
        const vec3 p =
            settled(centre + 70.0F * vec3(0, std::sin(angle), std::cos(angle)), mix(1.8F, 3.0F, t));
        if (step > 0)
            m_segments.push_back(
                {previous, p, mix(1.8F, 4.0F, t - 1.0F / steps), mix(1.8F, 4.0F, t)});
        previous = p;
    }
}

void VesselTree::sortIntoCells()
{
    const auto cellsOf = [](const Segment& segment, const auto& visit) {
        const float margin = std::max(segment.radiusA, segment.radiusB) + reach();
        const auto cell = [](const vec3& p) {
            return glm::clamp(
                glm::ivec3(glm::floor((p - gridOrigin) / cellMm)), glm::ivec3(0), gridSize - 1);
        };
        const glm::ivec3 low = cell(glm::min(segment.a, segment.b) - margin);
        const glm::ivec3 high = cell(glm::max(segment.a, segment.b) + margin);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x)
                    visit(cellIndex({x, y, z}));
            }
        }
    };
    m_cellStarts.assign(static_cast<std::size_t>(gridSize.x * gridSize.y * gridSize.z) + 1, 0);
    for (const Segment& segment : m_segments)
        cellsOf(segment, [&](int cell) { ++m_cellStarts[static_cast<std::size_t>(cell) + 1]; });
    for (std::size_t i = 1; i < m_cellStarts.size(); ++i)
        m_cellStarts[i] += m_cellStarts[i - 1];
    m_cellSegments.resize(m_cellStarts.back());
    std::vector<std::uint32_t> next(m_cellStarts.begin(), m_cellStarts.end() - 1);
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        cellsOf(m_segments[i], [&](int cell) {
            m_cellSegments[next[static_cast<std::size_t>(cell)]++] = static_cast<std::uint16_t>(i);
        });
    }
}

float VesselTree::distance(const vec3& p) const
{
    const glm::ivec3 cell(glm::floor((p - gridOrigin) / cellMm));
    if (glm::any(glm::lessThan(cell, glm::ivec3(0)))
        || glm::any(glm::greaterThanEqual(cell, gridSize)))
        return reach();
    const auto index = static_cast<std::size_t>(cellIndex(cell));
    float nearest = reach();
    for (std::uint32_t i = m_cellStarts[index]; i < m_cellStarts[index + 1]; ++i) {
        const Segment& s = m_segments[m_cellSegments[i]];
        nearest = std::min(nearest, capsule(p, s.a, s.b, s.radiusA, s.radiusB));
    }
    return nearest;
}

} // namespace core::demo

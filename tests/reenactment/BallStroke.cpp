// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/BallStroke.h"

#include "tests/reenactment/UserHand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace reenact {

namespace {

constexpr std::array<double, 11> radii{1.2, 2.0, 3.0, 4.0, 5.0, 6.5, 8.0, 10.0, 13.0, 16.0, 20.0};
constexpr std::size_t mostPlaces = 60;
constexpr int directions = 8;
constexpr int mostPoints = 14;

class Search {
public:
    Search(const UserEye& eye, const UserEye::Region& region, bool isDisc)
        : m_eye(eye)
        , m_region(region)
        , m_isDisc(isDisc)
        , m_stamps(eye.seen().values.size(), 0)
        , m_worth(eye.seen().values.size())
    {
        for (std::size_t at = 0; at < m_worth.size(); ++at)
            m_worth[at] = std::int8_t(eye.worth(at, region.isMissing));
    }

    BallStroke best(double leastRadius)
    {
        BallStroke best;
        for (const double radius : radii) {
            if (radius < leastRadius || radius > 2.0 * m_region.part.radius + 6.0)
                continue;
            BallStroke begun;
            for (int axis = 0; axis < 3; ++axis) {
                if (axis == 0 || m_isDisc) {
                    m_flat = m_isDisc ? axis : -1;
                    begun = bestPlace(radius);
                }
                if (begun.gain <= 0)
                    continue;
                BallStroke stroke = led(begun, axis);
                stroke.gain = unsteady(stroke);
                if (stroke.gain > best.gain)
                    best = std::move(stroke);
            }
        }
        return best;
    }

private:
    /// What a ball mends of what is not stamped as covered.
    int gainAt(const glm::dvec3& centre, double radius, bool stamps)
    {
        const Mask& seen = m_eye.seen();
        glm::ivec3 least = glm::max(glm::ivec3(glm::ceil(centre - radius)), glm::ivec3(0));
        glm::ivec3 most = glm::min(glm::ivec3(glm::floor(centre + radius)), seen.size - 1);
        if (m_flat >= 0) {
            least[m_flat] = most[m_flat] =
                std::clamp(int(std::lround(centre[m_flat])), 0, seen.size[m_flat] - 1);
        }
        int gain = 0;
        for (int z = least.z; z <= most.z; ++z) {
            for (int y = least.y; y <= most.y; ++y) {
                const double off =
                    (y - centre.y) * (y - centre.y) + (z - centre.z) * (z - centre.z);
                const double half = std::sqrt(std::max(0.0, radius * radius - off));
                if (off > radius * radius)
                    continue;
                const int first = std::max(least.x, int(std::ceil(centre.x - half)));
                const int last = std::min(most.x, int(std::floor(centre.x + half)));
                std::size_t at = seen.offset({first, y, z});
                for (int x = first; x <= last; ++x, ++at) {
                    if (m_stamps[at] == m_stamp)
                        continue;
                    gain += m_worth[at];
                    if (stamps)
                        m_stamps[at] = m_stamp;
                }
            }
        }
        return gain;
    }

    BallStroke bestPlace(double radius)
    {
        BallStroke best{.radius = radius, .points = {}, .gain = 0};
        ++m_stamp;
        const auto& voxels = m_region.part.voxels;
        const std::size_t stride = std::max<std::size_t>(1, voxels.size() / mostPlaces);
        const auto look = [&](glm::dvec3 place) {
            if (m_flat >= 0)
                place[m_flat] = std::round(place[m_flat]);
            const int gain = gainAt(place, radius, false);
            if (gain > best.gain)
                best = {.radius = radius, .points = {place}, .gain = gain};
        };
        for (std::size_t i = 0; i < voxels.size(); i += stride) {
            const glm::dvec3 place(voxels[i]);
            look(place);
            // Where it touches the organ's border.
            const double side = m_region.isMissing ? -1.0 : 1.0;
            const double leftOver = radius - std::abs(m_eye.offBorder(place));
            if (leftOver > 0.5)
                look(place + side * leftOver * m_eye.outwards(place));
        }
        look(glm::dvec3(m_region.part.deepest));
        return best;
    }

    /// What it would mend on average, as a hand leads it.
    [[nodiscard]] int unsteady(const BallStroke& stroke)
    {
        int sum = 0;
        int count = 0;
        for (int side = 0; side < 6; ++side) {
            glm::dvec3 off(0.0);
            off[side / 2] = (side % 2 == 0 ? 1.0 : -1.0) * UserHand::jitterVoxels;
            if (m_flat >= 0 && side / 2 == m_flat)
                continue;
            ++m_stamp;
            ++count;
            for (const glm::dvec3& place : alongWay(stroke.points, 0.4 * stroke.radius))
                sum += gainAt(place + off, stroke.radius, true);
        }
        return sum / count;
    }

    [[nodiscard]] static std::vector<glm::dvec3> alongWay(
        const std::vector<glm::dvec3>& points, double step)
    {
        std::vector<glm::dvec3> places{points.front()};
        for (std::size_t i = 1; i < points.size(); ++i) {
            const glm::dvec3 way = points[i] - points[i - 1];
            const int parts = std::max(1, int(std::ceil(glm::length(way) / step)));
            for (int part = 1; part <= parts; ++part)
                places.push_back(points[i - 1] + double(part) / double(parts) * way);
        }
        return places;
    }

    /// On and on to where it mends most, in a plane across an axis, to either end.
    BallStroke led(BallStroke stroke, int axis)
    {
        stroke.axis = axis;
        ++m_stamp;
        gainAt(stroke.points.front(), stroke.radius, true);
        for (int i = 1; i < mostPoints; ++i) {
            glm::dvec3 best(0.0);
            int gain = 0;
            for (int turn = 0; turn < directions; ++turn) {
                const double angle = 2.0 * std::numbers::pi * turn / directions;
                glm::dvec3 way(0.0);
                way[(axis + 1) % 3] = std::cos(angle);
                way[(axis + 2) % 3] = std::sin(angle);
                for (const double far : {0.5, 1.0}) {
                    const glm::dvec3 place =
                        stroke.points.back() + far * std::max(stroke.radius, 1.5) * way;
                    const int there = gainAt(place, stroke.radius, false);
                    if (there <= gain)
                        continue;
                    gain = there;
                    best = place;
                }
            }
            if (gain <= std::max(2, stroke.gain / 50))
                break;
            // What it passes counts, too.
            const glm::dvec3 from = stroke.points.back();
            int passed = 0;
            for (int part = 1; part <= 3; ++part)
                passed += gainAt(from + part / 3.0 * (best - from), stroke.radius, true);
            stroke.gain += passed;
            stroke.points.push_back(best);
        }
        return stroke;
    }

    const UserEye& m_eye;
    const UserEye::Region& m_region;
    bool m_isDisc;
    std::vector<int> m_stamps;
    std::vector<std::int8_t> m_worth;
    int m_stamp = 0;
    int m_flat = -1; ///< the axis across which all is flat; −1: balls
};

} // namespace

BallStroke bestStroke(
    const UserEye& eye, const UserEye::Region& region, double leastRadius, bool isDisc)
{
    return Search(eye, region, isDisc).best(leastRadius);
}

} // namespace reenact

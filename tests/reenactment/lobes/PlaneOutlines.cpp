// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/lobes/PlaneOutlines.h"

#include <map>

namespace reenact {

namespace {

class Outlines {
public:
    Outlines(const CuttingPlane& plane, double stepMm)
        : m_plane(plane)
        , m_stepMm(stepMm)
        , m_half(int(plane.halfMm / stepMm) + 2)
    {
    }

    [[nodiscard]] std::vector<PlaneLine> of(
        const std::function<double(const glm::dvec3& placeLps)>& valueAt)
    {
        const int count = 2 * m_half + 1;
        std::vector<double> values;
        values.reserve(std::size_t(count) * std::size_t(count));
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
        return m_plane.middleLps
            + m_stepMm
            * (double(i - m_half) * m_plane.rightLps + double(j - m_half) * m_plane.downLps);
    }

    [[nodiscard]] std::vector<PlaneLine> chained()
    {
        std::vector<PlaneLine> lines;
        while (!m_next.empty()) {
            PlaneLine line;
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

    CuttingPlane m_plane;
    double m_stepMm;
    int m_half;
    std::map<int, glm::dvec3> m_places;
    std::map<int, std::vector<int>> m_next;
};

} // namespace

glm::dvec3 axisBeside(const glm::dvec3& normal)
{
    const glm::dvec3 slant = glm::abs(normal);
    const glm::dvec3 axis = slant.x <= slant.y && slant.x <= slant.z ? glm::dvec3(1, 0, 0)
        : slant.y <= slant.z                                         ? glm::dvec3(0, 1, 0)
                                                                     : glm::dvec3(0, 0, 1);
    return glm::normalize(axis - glm::dot(axis, normal) * normal);
}

CuttingPlane CuttingPlane::through(
    const core::VolumeGeometry& geometry, const glm::dvec3& placeLps, const glm::dvec3& normalLps)
{
    const glm::dvec3 size(geometry.size);
    const glm::dvec3 middle = geometry.toWorld(0.5 * (size - 1.0));
    CuttingPlane plane;
    plane.middleLps = middle + glm::dot(placeLps - middle, normalLps) * normalLps;
    plane.rightLps = axisBeside(normalLps);
    plane.downLps = glm::cross(normalLps, plane.rightLps);
    plane.halfMm = 0.5 * glm::distance(geometry.toWorld(glm::dvec3(0.0)), geometry.toWorld(size));
    return plane;
}

std::vector<PlaneLine> outlinesOn(const CuttingPlane& plane, double stepMm,
    const std::function<double(const glm::dvec3& placeLps)>& valueAt)
{
    return Outlines(plane, stepMm).of(valueAt);
}

} // namespace reenact

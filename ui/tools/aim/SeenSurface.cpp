// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/SeenSurface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

namespace {

double distanceToLine(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to)
{
    const glm::dvec2 along = to - from;
    const double squared = glm::dot(along, along);
    const double t =
        squared > 0.0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, from + t * along);
}

} // namespace

SeenSurface::SeenSurface(const gpu::VolumeScene& scene, const core::Volume& volume, double radiusMm,
    double reachMm, std::optional<std::bitset<256>> segments)
    : m_scene(scene)
    , m_volume(volume)
    , m_segments(segments)
    , m_radiusMm(radiusMm)
{
    m_forward = glm::normalize(scene.targetLps - scene.eyeLps);
    m_right = glm::normalize(glm::cross(m_forward, scene.up));
    m_up = glm::cross(m_right, m_forward);
    const glm::dvec3 spacing = volume.geometry.spacingMm();
    m_stepMm = std::max(radiusMm / 4.0, std::min({spacing.x, spacing.y, spacing.z}));
    m_reachMm = reachMm + 2.0 * m_stepMm;
}

std::vector<std::pair<int, int>> SeenSurface::cellsAhead(
    const glm::dvec2& from, const glm::dvec2& to)
{
    const glm::ivec2 first(glm::floor((glm::min(from, to) - m_reachMm) / m_stepMm));
    const glm::ivec2 last(glm::ceil((glm::max(from, to) + m_reachMm) / m_stepMm));
    std::vector<std::pair<int, int>> cells;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            if (distanceToLine(glm::dvec2(x, y) * m_stepMm, from, to) <= m_reachMm
                && m_depths.try_emplace({x, y}, std::nullopt).second)
                cells.emplace_back(x, y);
        }
    }
    return cells;
}

core::PickQuestion SeenSurface::question(const std::vector<std::pair<int, int>>& cells) const
{
    std::vector<glm::dvec2> planeMm;
    planeMm.reserve(cells.size());
    for (const auto& cell : cells)
        planeMm.emplace_back(cell.first * m_stepMm, cell.second * m_stepMm);
    core::PickQuestion question = pickQuestion(m_scene, planeMm, m_volume);
    if (m_segments) {
        question.seenBy = core::SeenBy::Segment;
        question.segments = *m_segments;
    }
    return question;
}

void SeenSurface::take(const std::vector<std::pair<int, int>>& cells, const PickedVoxels& picked)
{
    for (std::size_t i = 0; i < cells.size() && i < picked.size(); ++i) {
        if (picked[i]) {
            const glm::dvec3 seen = m_volume.geometry.toWorld(glm::dvec3(*picked[i]));
            m_depths[cells[i]] = glm::dot(seen - m_scene.targetLps, m_forward);
        }
    }
}

std::optional<double> SeenSurface::depthOf(int x, int y) const
{
    const auto found = m_depths.find({x, y});
    return found == m_depths.end() ? std::nullopt : found->second;
}

std::optional<glm::dvec3> SeenSurface::at(const glm::dvec2& planeMm) const
{
    const glm::dvec2 place = planeMm / m_stepMm;
    const glm::ivec2 low(glm::floor(place));
    const glm::dvec2 part = place - glm::dvec2(low);
    std::array<std::optional<double>, 4> corners;
    double nearest = 1e18;
    double farthest = -1e18;
    for (int corner = 0; corner < 4; ++corner) {
        corners[std::size_t(corner)] = depthOf(low.x + (corner & 1), low.y + (corner >> 1));
        nearest = std::min(nearest, corners[std::size_t(corner)].value_or(-1e18));
        farthest = std::max(farthest, corners[std::size_t(corner)].value_or(1e18));
    }
    double depth = 0.0;
    // Between things at different depths there is no surface: the nearest ray says where it is.
    if (farthest - nearest <= m_radiusMm) {
        depth = (*corners[0] * (1 - part.x) + *corners[1] * part.x) * (1 - part.y)
            + (*corners[2] * (1 - part.x) + *corners[3] * part.x) * part.y;
    } else {
        const int corner = (part.x < 0.5 ? 0 : 1) + (part.y < 0.5 ? 0 : 2);
        if (!corners[std::size_t(corner)])
            return std::nullopt;
        depth = *corners[std::size_t(corner)];
    }
    return m_scene.targetLps + m_right * planeMm.x + m_up * planeMm.y + m_forward * depth;
}

} // namespace ui

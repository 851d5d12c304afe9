// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/EdgeTracks.h"

#include <algorithm>
#include <cmath>

namespace core {

EdgeTracks::EdgeTracks(double reachMm)
    : m_reachMm(reachMm)
{
}

void EdgeTracks::add(
    const glm::dvec3& fromLps, const glm::dvec3& toLps, const glm::dvec3& unitNormal)
{
    const auto track = std::uint32_t(m_tracks.size());
    m_tracks.push_back({.from = fromLps, .to = toLps, .normal = unitNormal});
    // Half a cell from one to the next: none that it passes is more than a neighbour of these.
    const int steps = int(std::ceil(2.0 * glm::distance(fromLps, toLps) / m_reachMm));
    for (int i = 0; i <= steps; ++i) {
        const double share = steps == 0 ? 0.0 : double(i) / double(steps);
        std::vector<std::uint32_t>& cell = m_cells[keyOf(cellOf(glm::mix(fromLps, toLps, share)))];
        if (cell.empty() || cell.back() != track)
            cell.push_back(track);
    }
}

std::optional<glm::dvec3> EdgeTracks::leftMm(const glm::dvec3& placeLps) const
{
    std::vector<std::uint32_t> near;
    const glm::ivec3 middle = cellOf(placeLps);
    for (int i = 0; i < 27; ++i) {
        const auto cell = m_cells.find(keyOf(middle + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1));
        if (cell != m_cells.end())
            near.insert(near.end(), cell->second.begin(), cell->second.end());
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());

    double weights = 0.0;
    double leftMm = 0.0;
    glm::dvec3 normal(0.0);
    for (const std::uint32_t index : near) {
        const Track& track = m_tracks[index];
        const glm::dvec3 way = track.to - track.from;
        const double length = glm::dot(way, way);
        const double share = length > 0.0
            ? std::clamp(glm::dot(placeLps - track.from, way) / length, 0.0, 1.0)
            : 0.0;
        const glm::dvec3 off = placeLps - (track.from + share * way);
        const double far = glm::dot(off, off) / (m_reachMm * m_reachMm);
        if (far >= 1.0)
            continue;
        const double weight = (1.0 - far) * (1.0 - far);
        weights += weight;
        leftMm += weight * glm::dot(track.to - placeLps, track.normal);
        normal += weight * track.normal;
    }
    const double length = glm::length(normal);
    // Where ways cross each other there is no telling.
    if (weights <= 0.0 || length < 0.5 * weights)
        return std::nullopt;
    return leftMm / weights * (normal / length);
}

glm::ivec3 EdgeTracks::cellOf(const glm::dvec3& placeLps) const
{
    return glm::ivec3(glm::floor(placeLps / m_reachMm));
}

std::uint64_t EdgeTracks::keyOf(const glm::ivec3& cell)
{
    constexpr std::uint64_t mask = (std::uint64_t(1) << 21) - 1;
    return (std::uint64_t(std::uint32_t(cell.x)) & mask)
        | (std::uint64_t(std::uint32_t(cell.y)) & mask) << 21
        | (std::uint64_t(std::uint32_t(cell.z)) & mask) << 42;
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/refine/voxels/GreyBox.h"

#include <QtGlobal>

#include <algorithm>
#include <cmath>

namespace core {

GreyBox::GreyBox(const VolumeGeometry& geometry, const glm::ivec3& first, const glm::ivec3& size,
    std::vector<std::uint16_t> codes)
    : m_toIndex(geometry)
    , m_first(first)
    , m_size(size)
    , m_codes(std::move(codes))
{
    const glm::dvec3 spacing = geometry.spacingMm();
    m_stepMm = 0.5 * std::min({spacing.x, spacing.y, spacing.z});
    Q_ASSERT(m_codes.size() == std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
}

double GreyBox::at(const glm::dvec3& placeLps) const
{
    if (m_codes.empty())
        return 0.0;
    const glm::dvec3 place = glm::clamp(
        m_toIndex(placeLps) - glm::dvec3(m_first), glm::dvec3(0.0), glm::dvec3(m_size - 1));
    const glm::ivec3 low = glm::min(glm::ivec3(place), glm::max(m_size - 2, glm::ivec3(0)));
    const glm::ivec3 high = glm::min(low + 1, m_size - 1);
    const glm::dvec3 share = place - glm::dvec3(low);
    const auto code = [&](int x, int y, int z) {
        return double(m_codes[(std::size_t(z) * std::size_t(m_size.y) + std::size_t(y))
                * std::size_t(m_size.x)
            + std::size_t(x)]);
    };
    const auto along = [&](int y, int z) {
        return (1.0 - share.x) * code(low.x, y, z) + share.x * code(high.x, y, z);
    };
    const double front = (1.0 - share.y) * along(low.y, low.z) + share.y * along(high.y, low.z);
    const double back = (1.0 - share.y) * along(low.y, high.z) + share.y * along(high.y, high.z);
    return (1.0 - share.z) * front + share.z * back;
}

EdgeProfile GreyBox::profileAlong(
    const glm::dvec3& placeLps, const glm::dvec3& unitWay, double reachMm) const
{
    constexpr int mostSteps = 400;
    constexpr int half = 2;
    // One more on either side, for what is steepest at the end.
    const int steps = std::min(mostSteps, int(std::ceil(reachMm / m_stepMm))) + 1;
    std::vector<double> values;
    values.reserve(std::size_t(2 * (steps + half) + 1));
    for (int i = -steps - half; i <= steps + half; ++i)
        values.push_back(at(placeLps + double(i) * m_stepMm * unitWay));
    EdgeProfile profile{.stepMm = m_stepMm};
    profile.changes.reserve(std::size_t(2 * steps + 1));
    for (std::size_t i = 2 * half; i < values.size(); ++i)
        profile.changes.push_back(values[i] - values[i - 2 * half]);
    return profile;
}

std::optional<double> EdgeProfile::edgeMm() const
{
    const int steps = int(changes.size() / 2) - 1;
    const auto steepAt = [&](int i) { return std::abs(changes[std::size_t(i + steps + 1)]); };
    const auto scoreAt = [&](int i) {
        const double far = double(i) / double(steps + 1);
        return steepAt(i) * (1.0 - far * far);
    };
    int best = 0;
    for (int distance = 1; distance <= steps; ++distance) {
        for (const int i : {-distance, distance}) {
            if (scoreAt(i) > scoreAt(best))
                best = i;
        }
    }
    if (scoreAt(best) < 1.0)
        return std::nullopt;
    // Nearness tells which edge, not where it is.
    while (best < steps && steepAt(best + 1) > steepAt(best))
        ++best;
    while (best > -steps && steepAt(best - 1) > steepAt(best))
        --best;
    // The top of the parabola through it and its neighbours.
    const double before = steepAt(best - 1);
    const double after = steepAt(best + 1);
    const double bend = before - 2.0 * steepAt(best) + after;
    const double off = bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
    return (double(best) + off) * stepMm;
}

} // namespace core

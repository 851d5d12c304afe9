// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/UserEye.h"

#include <algorithm>
#include <cmath>

namespace reenact {

UserEye::UserEye(const Mask& seen, const Mask& organ)
    : m_seen(seen)
    , m_organ(organ)
    , m_offOrgan(signedDistance(organ))
    , m_offSeen(signedDistance(seen))
    , m_soft(smoothed(organ))
{
}

int UserEye::worth(std::size_t at, bool adds) const
{
    const bool isIn = m_seen.values[at] != 0;
    const bool belongs = m_organ.values[at] != 0;
    if (isIn == adds)
        return 0;
    return belongs == adds ? 1 : -1;
}

double UserEye::offBorder(const glm::dvec3& index) const
{
    return sampled(m_offOrgan, index);
}

double UserEye::offSeen(const glm::dvec3& index) const
{
    return sampled(m_offSeen, index);
}

glm::dvec3 UserEye::outwards(const glm::dvec3& index) const
{
    // Beside the border the smooth mask says it better than distances between voxels do.
    const bool isNear = std::abs(offBorder(index)) < 1.5;
    const Field& field = isNear ? m_soft : m_offOrgan;
    glm::dvec3 rise(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0.0);
        step[axis] = 1.0;
        rise[axis] = sampled(field, index + step) - sampled(field, index - step);
    }
    if (isNear)
        rise = -rise;
    const double length = glm::length(rise);
    return length > 1e-9 ? rise / length : glm::dvec3(0.0, 0.0, 1.0);
}

std::vector<UserEye::Region> UserEye::regions() const
{
    std::vector<Region> regions;
    for (const double least : {1.0, 0.0}) {
        for (const bool isMissing : {false, true}) {
            Mask wrong = m_seen;
            Mask plain = m_seen;
            for (std::size_t at = 0; at < wrong.values.size(); ++at) {
                const bool isWrong = m_seen.values[at] != m_organ.values[at]
                    && (m_organ.values[at] != 0) == isMissing;
                wrong.values[at] = isWrong ? 1 : 0;
                plain.values[at] =
                    isWrong && std::abs(double(m_offOrgan.values[at])) > least ? 1 : 0;
            }
            for (MaskPart& part : partsOf(plain)) {
                // With what is wrong beside it.
                Mask taken{plain.size, std::vector<std::uint8_t>(plain.values.size(), 0)};
                for (const glm::ivec3& voxel : part.voxels)
                    taken.at(voxel) = 1;
                const std::size_t core = part.voxels.size();
                for (std::size_t i = 0; i < core && least > 0.0; ++i) {
                    for (int side = 0; side < 27; ++side) {
                        const glm::ivec3 near = part.voxels[i]
                            + glm::ivec3(side % 3 - 1, side / 3 % 3 - 1, side / 9 - 1);
                        if (!taken.contains(near) || taken.at(near) != 0 || wrong.at(near) == 0)
                            continue;
                        taken.at(near) = 1;
                        part.voxels.push_back(near);
                    }
                }
                regions.push_back({.isMissing = isMissing, .part = std::move(part)});
            }
        }
        if (!regions.empty())
            break;
    }
    std::stable_sort(regions.begin(), regions.end(),
        [](const Region& a, const Region& b) { return a.weight() > b.weight(); });
    return regions;
}

} // namespace reenact

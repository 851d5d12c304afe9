// SPDX-License-Identifier: Apache-2.0
// VoxelFields: a segment is shown as it would be at a tolerance.
#include "gpu/fields/VoxelFields.h"

#include <algorithm>

namespace gpu {

namespace {

constexpr std::uint32_t noneInBrick = 0xFFFFu; // ToleranceField::ranges

} // namespace

std::optional<int> VoxelFields::shownTolerance() const
{
    const bool shown = m_tolerance.stands && m_tolerance.rule.plane == m_growthPlane
        && placeOf(m_growthPlane) && m_atTolerance
        && m_atTolerance->label == int(m_tolerance.rule.label);
    return shown ? std::optional(m_atTolerance->tolerance) : std::nullopt;
}

void VoxelFields::standTolerance()
{
    m_tolerance.stands = true;
    shareTolerances();
    noteTolerance(std::nullopt);
}

void VoxelFields::shareTolerances()
{
    const bool isShown = m_tolerance.stands && m_tolerance.rule.plane == m_growthPlane;
    m_shared.setTolerances(
        isShown ? &m_tolerance.tolerances : nullptr, isShown ? m_tolerance.rule.label : 0);
}

void VoxelFields::hideTolerance()
{
    const std::optional<int> before = shownTolerance();
    m_tolerance.stands = false;
    shareTolerances();
    noteTolerance(before);
}

void VoxelFields::dropTolerance()
{
    hideTolerance();
    m_tolerance = {};
}

void VoxelFields::showAtTolerance(const std::optional<ToleranceDisplay>& shown)
{
    const std::optional<int> before = shownTolerance();
    m_atTolerance = shown;
    noteTolerance(before);
}

void VoxelFields::noteTolerance(std::optional<int> before)
{
    const std::optional<int> now = shownTolerance();
    if (before == now)
        return;
    // Between two tolerances slices are asked for anew anyway; what comes and goes they must be
    // told.
    if (!before || !now)
        m_shared.markDirty(VolumeField::Labels, {glm::ivec3(0), m_grid.volumeSize});
    if (!m_shownLabels.test(m_tolerance.rule.label))
        return;
    std::vector<std::uint32_t> changed;
    const int low = before && now ? std::min(*before, *now) : -1;
    const int high = std::max(before.value_or(-1), now.value_or(-1));
    for (std::uint32_t brick = 0; brick < m_tolerance.ranges.size(); ++brick) {
        const std::uint32_t least = m_tolerance.ranges[brick] & 0xFFFFu;
        const std::uint32_t greatest = m_tolerance.ranges[brick] >> 16;
        const bool between = least != noneInBrick && int(least) <= high && int(greatest) > low;
        const bool mayHide = (!before || !now) && m_labelledBricks.contains(brick);
        if (between || mayHide)
            changed.push_back(brick);
    }
    for (const std::uint32_t brick : withNeighbours(changed))
        m_staleSegmentation.insert(brick);
}

} // namespace gpu

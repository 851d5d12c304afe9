// SPDX-License-Identifier: Apache-2.0
// What of a growth leaves when a burst opens (core::GrowOpening).
#include "gpu/kernels/growth/GrowthKernel.h"
#include "gpu/kernels/shrink/ShrinkKernel.h"

#include <algorithm>
#include <utility>

namespace gpu {

void GrowthKernel::narrow(const std::vector<std::uint32_t>& held)
{
    const std::shared_ptr<GrowthPrograms::Narrowing> programs = m_programs.narrowing(m_kind);
    GrowthPrograms::Narrowing& narrowing = *programs;
    for (Program* each : {&narrowing.doubt, &narrowing.back.front, &narrowing.back.ring,
             &narrowing.back.severalRings, &narrowing.sweep})
        setUniforms(*each);
    const std::uint32_t capacity = m_queueCapacity;
    runOver(narrowing.doubt, held);
    GrowthPrograms::Rings* const forward = std::exchange(m_rings, &narrowing.back);
    floodBack();
    m_rings = forward;
    if (m_queueCapacity != capacity)
        setQueues(m_queueCapacity); // those of the growth are told too
    m_generation = runOver(narrowing.sweep, held).greatest;
}

/// Unlike a front that grows, this one stays in bricks that have pages and are captured.
void GrowthKernel::floodBack()
{
    const std::vector<std::uint32_t> held = m_fields.seedWords(m_burst.plane).heldBricks();
    m_floodsBack = true;
    findFront(held);
    while (m_frontCount > 0) {
        State state;
        state.counts[0] = m_frontCount;
        start(state);
        runRings(ringsPerBatch);
        state = takeBatch();
        m_frontCount = state.counts[ringsPerBatch];
        const std::uint32_t longest = *std::max_element(state.counts.begin(), state.counts.end());
        if (longest > m_queueCapacity) {
            setQueues(4 * m_queueCapacity);
            findFront(held);
        }
    }
    m_floodsBack = false;
}

void GrowthKernel::restart()
{
    const ShrinkKernel shrink(m_programs.shrink, m_fields, m_before,
        {.plane = m_burst.plane,
            .generation = m_generation,
            .keep = 0,
            .keepSeeds = false,
            .lockedLabels = m_burst.lockedLabels});
    for (const core::BrickKey& key : shrink.touchedKeys())
        m_allTouched.insert(key.brick);
    m_generation = shrink.generation();
}

} // namespace gpu

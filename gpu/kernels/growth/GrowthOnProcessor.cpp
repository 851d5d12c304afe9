// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/growth/GrowthKernel.h"

namespace gpu {

bool GrowthKernel::isOnProcessor() const
{
    // The backward flood, which narrows a growth, claims nothing.
    return m_programs.growsOnProcessor() && !m_floodsBack && m_onlyLabel
        && FrontBits::isFor(m_burst.limits);
}

int GrowthKernel::advanceOnProcessor(int rings)
{
    const std::vector<std::uint32_t> reachable = prepareBricks();
    if (!m_processorFront) {
        const ProcessorFront::Options options{.label = *m_onlyLabel,
            .plane = m_burst.plane,
            .connectivity = m_burst.connectivity,
            .tellsHeld = m_burst.tellsHeld,
            .keepsOverwritten = m_kind.overwritten};
        m_processorFront.emplace(m_fields, options, listedFront(), m_generation);
    }
    ProcessorFront& front = *m_processorFront;
    const std::vector<std::uint32_t> unknown = front.unknown(reachable);
    if (!unknown.empty()) {
        const std::shared_ptr<Program> program = m_programs.openBits(m_kind);
        setUniforms(*program);
        bind();
        front.setOpen(unknown,
            openBits(*program, m_fields.seedWords(m_burst.plane), m_fields.grid().bricks(),
                *m_onlyLabel, unknown));
    }
    const std::vector<std::uint32_t> sizes = front.advance(m_generation, rings, m_newPages);
    count(sizes);
    m_frontCount = int(sizes.size()) == rings ? sizes.back() : 0;
    m_frontBricks = front.frontBricks();
    m_lastTouched = front.written();
    m_allTouched.insert(m_lastTouched.begin(), m_lastTouched.end());
    if (!m_lastTouched.empty())
        m_fields.noteChanged(core::Field::Labels, m_lastTouched);
    if (m_guard && !sizes.empty())
        watch(front.voxels());
    return int(sizes.size());
}

} // namespace gpu

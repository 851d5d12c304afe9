// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/labels/ScissorsReach.h"

#include <algorithm>
#include <cstdlib>

namespace gpu {

namespace {

using core::fixedPoint::round14;

} // namespace

ScissorsReach::ScissorsReach(
    LabelPrograms& programs, VoxelFields& fields, const core::LabelScissors& edit)
    : m_programs(programs)
    , m_fields(fields)
    , m_edit(edit)
{
    if (!edit.fromSurface) {
        finish();
        return;
    }
    m_surfaces.resize(edit.mask.values.size(), core::SurfaceHit::none);
    std::vector<std::uint32_t> concerned(
        std::size_t(fields.grid().brickCount()), edit.erases() ? 0 : 1);
    if (edit.erases()) {
        for (const std::uint32_t brick : fields.labelledBricks())
            concerned[brick] = 1;
    }
    m_concerned = bufferOf("scissors concerned", concerned);
    if (m_surfaces.empty())
        finish();
}

void ScissorsReach::advance(std::size_t elements)
{
    if (isKnown())
        return;
    const Rays rays = raysUpTo(std::min(m_next + elements, m_surfaces.size()));
    if (!rays.elements.empty())
        cast(rays);
    if (m_next == m_surfaces.size())
        finish();
}

ScissorsReach::Rays ScissorsReach::raysUpTo(std::size_t end)
{
    constexpr std::int64_t farthest = std::int64_t(1) << 30; // core/sculpt/CutFrame.h, rule 2
    const core::CutFrame& frame = m_edit.frame;
    const glm::ivec3 step = round14(frame.rayPerSample);
    Rays rays;
    for (; m_next < end; ++m_next) {
        if (m_edit.mask.values[m_next] < core::LabelScissors::covered)
            continue;
        const auto columns = std::size_t(m_edit.mask.size.x);
        const std::int64_t a = m_edit.mask.first.x + std::int64_t(m_next % columns);
        const std::int64_t b = m_edit.mask.first.y + std::int64_t(m_next / columns);
        glm::ivec3 origin(0);
        bool isNear = true;
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = std::size_t(axis);
            const std::int64_t position =
                round14(frame.rayOrigin[i] + a * frame.rayPerA[i] + b * frame.rayPerB[i]);
            isNear = isNear && std::abs(position) <= farthest;
            origin[axis] = int(std::clamp(position, -farthest, farthest));
        }
        if (!isNear)
            continue;
        const core::SeenSamples samples =
            core::samplesWithin(core::seenSamples(frame.hidden, origin, step, frame.sampleCount),
                origin, step, {glm::ivec3(0), m_fields.grid().volumeSize});
        if (samples.first >= samples.end)
            continue;
        rays.elements.push_back(m_next);
        rays.origins.emplace_back(origin, 0);
        rays.samples.emplace_back(samples.first, samples.end);
    }
    return rays;
}

void ScissorsReach::cast(const Rays& rays)
{
    const core::CutFrame& frame = m_edit.frame;
    const Buffer origins = bufferOf("scissors rays", rays.origins);
    const Buffer samples = bufferOf("scissors samples", rays.samples);
    std::vector<std::int32_t> found(rays.elements.size(), core::SurfaceHit::none);
    const Buffer surfaces = bufferOf("scissors surfaces", found);
    const bool none = m_edit.lowCode > m_edit.highCode || m_edit.highCode < 0;
    Program& kernel = m_programs.scissorsCast();
    kernel.set("rayCount", unsigned(rays.elements.size()))
        .set("stepPerSample", round14(frame.rayPerSample))
        .set("volumeBricks", m_fields.grid().bricks())
        .set("zStart", frame.zStart)
        .set("zPerSample", frame.zPerSample)
        .set("lowCode", none ? 65536u : unsigned(std::max(m_edit.lowCode, 0)))
        .set("highCode", none ? 0u : unsigned(m_edit.highCode))
        .set("erases", m_edit.erases())
        .set("erased", m_edit.erased);
    m_fields.codes().bindUnit(0);
    m_fields.labels(m_edit.target.plane).bindUnit(1);
    m_fields.codeRanges().bindUnit(2);
    origins.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    surfaces.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    samples.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_concerned.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    kernel.dispatch({unsigned(rays.elements.size() + 63) / 64, 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    surfaces.read(std::span<std::int32_t>(found));
    for (std::size_t i = 0; i < found.size(); ++i)
        m_surfaces[rays.elements[i]] = found[i];
}

void ScissorsReach::finish()
{
    m_reach = bufferOf("scissors reach", core::scissorsReach(m_edit, m_surfaces));
}

} // namespace gpu

// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/ColumnCutter.h"

#include "gpu/fields/bricks/HiddenBricks.h"

#include <algorithm>

namespace gpu {

using core::fixedPoint::round14;

ColumnCutter::ColumnCutter(Program& cut, VoxelFields& fields, BeforeImages& before,
    const core::CutFrame& frame, const CoverageWriter::Target& target)
    : m_cut(cut)
    , m_fields(fields)
    , m_frame(frame)
    , m_writer(fields, before, target)
{
    m_cut.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("planePerI", round14(frame.planePerI))
        .set("planePerJ", round14(frame.planePerJ))
        .set("planePerK", round14(frame.planePerK))
        .set("pitch", frame.pitch)
        .set("rampHalfWidth", frame.rampHalfWidth);
    m_writer.prepare(m_cut);
    setHidden(m_cut, frame.hidden);
}

std::vector<std::uint32_t> ColumnCutter::lay(CutColumns& columns)
{
    const PlaneAxes axes{core::planeBase(m_frame, glm::ivec3(0)), round14(m_frame.planePerI),
        round14(m_frame.planePerJ), round14(m_frame.planePerK)};
    const std::vector<std::uint32_t> candidates =
        m_writer.begin(bricksUnder(axes, m_fields.grid(), columns.takeChanged()));
    if (candidates.empty())
        return {};

    std::vector<glm::ivec4> bases;
    for (const std::uint32_t brick : candidates) {
        const glm::ivec3 voxel = m_fields.grid().boxOf(int(brick)).minimum;
        bases.emplace_back(core::planeBase(m_frame, voxel), int(brick));
    }
    Buffer baseBuffer({.label = "mask candidates", .bytes = bases.size() * sizeof(glm::ivec4)});
    baseBuffer.write(std::span<const glm::ivec4>(bases));
    Buffer changedBuffer(
        {.label = "mask changed", .bytes = candidates.size() * sizeof(std::uint32_t)});
    changedBuffer.fill(0);
    const Buffer hidden = hiddenBases(m_frame.hidden, m_fields.grid(), candidates);
    baseBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    columns.bind(1, 2);
    changedBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    hidden.bindBase(GL_SHADER_STORAGE_BUFFER, 6);
    m_cut.set("firstTile", columns.firstTile())
        .set("tileCount", columns.tileCount())
        .set("candidateCount", unsigned(candidates.size()));
    m_cut.dispatch({unsigned(std::min(candidates.size(), mostWorkGroups)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);

    std::vector<std::uint32_t> flags(candidates.size());
    changedBuffer.read(std::span<std::uint32_t>(flags));
    return m_writer.end(flags);
}

} // namespace gpu

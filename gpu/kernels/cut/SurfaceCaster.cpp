// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/SurfaceCaster.h"

#include <algorithm>
#include <cstdlib>

namespace gpu {

namespace {

using core::fixedPoint::round14;

constexpr std::size_t brickBytes = core::BrickGrid::voxelsPerBrick;
constexpr std::int64_t farthest = std::int64_t(1) << 30; ///< index16, of a ray's start

} // namespace

SurfaceCaster::SurfaceCaster(Program& cast, VoxelFields& fields, const core::CutFrame& frame)
    : m_cast(cast)
    , m_fields(fields)
    , m_frame(frame)
    , m_snapshotSlots({.label = "snapshot slots",
          .bytes = std::size_t(fields.grid().brickCount()) * sizeof(std::uint32_t)})
    , m_snapshotOf(std::size_t(fields.grid().brickCount()), 0)
    , m_snapshots({.label = "radiation snapshots", .bytes = brickBytes})
{
    m_snapshotSlots.fill(0);
    m_cast.set("stepPerSample", round14(frame.rayPerSample))
        .set("zStart", frame.zStart)
        .set("zPerSample", frame.zPerSample)
        .set("maxDepth", frame.maxDepth)
        .set("gapSamples", frame.gapSamples)
        .set("throughGaps", frame.throughGaps)
        .set("front", frame.front);
}

void SurfaceCaster::show(Program& program) const
{
    program.set("volumeSize", m_fields.grid().volumeSize)
        .set("volumeBricks", m_fields.grid().bricks())
        .set("thresholdCode", m_frame.thresholdCode)
        .set("restore", m_frame.restore)
        .set("asWhole", m_frame.asWhole);
    m_fields.codes().bindUnit(0);
    m_fields.radiation().bindUnit(1);
    m_snapshotSlots.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_snapshots.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
}

std::vector<core::SurfaceHit> SurfaceCaster::cast(std::span<const glm::ivec2> elements)
{
    std::vector<core::SurfaceHit> hits(elements.size());
    std::vector<std::size_t> places;
    std::vector<glm::ivec4> rays;
    std::vector<glm::ivec2> seen;
    const glm::ivec3 step = round14(m_frame.rayPerSample);
    for (std::size_t place = 0; place < elements.size(); ++place) {
        const glm::ivec2& at = elements[place];
        glm::ivec4 origin(0);
        bool near = true;
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = std::size_t(axis);
            const std::int64_t position = round14(
                m_frame.rayOrigin[i] + at.x * m_frame.rayPerA[i] + at.y * m_frame.rayPerB[i]);
            near = near && std::abs(position) <= farthest;
            origin[axis] = int(std::clamp(position, -farthest, farthest));
        }
        if (near) {
            places.push_back(place);
            rays.push_back(origin);
            const core::SeenSamples samples =
                core::seenSamples(m_frame.hidden, glm::ivec3(origin), step, m_frame.sampleCount);
            seen.emplace_back(samples.first, samples.end);
        }
    }
    if (rays.empty())
        return hits;

    Buffer rayBuffer({.label = "mask rays", .bytes = rays.size() * sizeof(glm::ivec4)});
    rayBuffer.write(std::span<const glm::ivec4>(rays));
    Buffer hitBuffer({.label = "mask hits", .bytes = rays.size() * sizeof(glm::ivec2)});
    Buffer seenBuffer({.label = "mask rays seen", .bytes = seen.size() * sizeof(glm::ivec2)});
    seenBuffer.write(std::span<const glm::ivec2>(seen));
    show(m_cast);
    m_fields.codeRanges().bindUnit(2);
    rayBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    hitBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    seenBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    m_cast.set("rayCount", unsigned(rays.size()));
    m_cast.dispatch({unsigned(rays.size() + 63) / 64, 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::vector<glm::ivec2> found(rays.size());
    hitBuffer.read(std::span<glm::ivec2>(found));
    for (std::size_t i = 0; i < found.size(); ++i)
        hits[places[i]] = {found[i].x, found[i].y};
    for (std::size_t i = 0; i < hits.size(); ++i) {
        m_searchedTo = std::max(m_searchedTo,
            core::searchEnd(m_frame, m_fields.grid().volumeSize, elements[i], hits[i]));
    }
    return hits;
}

void SurfaceCaster::keepRadiation(std::span<const std::uint32_t> bricks)
{
    std::vector<std::uint32_t> fresh;
    for (const std::uint32_t brick : m_fields.withNeighbours(bricks)) {
        if (m_snapshotOf[brick] == 0)
            fresh.push_back(brick);
    }
    if (fresh.empty())
        return;
    const std::uint32_t needed = m_snapshotCount + std::uint32_t(fresh.size());
    if (needed > m_snapshotCapacity) {
        m_snapshotCapacity = std::max(needed * 2, 256u);
        Buffer larger({.label = "radiation snapshots", .bytes = m_snapshotCapacity * brickBytes});
        m_snapshots.copyTo(larger, m_snapshotCount * brickBytes);
        m_snapshots = std::move(larger);
    }
    const FieldTextures radiation{.voxels = &m_fields.radiation()};
    const Buffer packed = m_fields.copier().packed(radiation, fresh);
    packed.copyTo(m_snapshots, fresh.size() * brickBytes, 0, m_snapshotCount * brickBytes);
    for (const std::uint32_t brick : fresh)
        m_snapshotOf[brick] = ++m_snapshotCount;
    m_snapshotSlots.write(std::span<const std::uint32_t>(m_snapshotOf));
}

} // namespace gpu

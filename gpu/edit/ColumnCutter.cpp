// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/ColumnCutter.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace gpu {

using core::fixedPoint::round14;

ColumnCutter::ColumnCutter(Program& cut, VoxelFields& fields, BeforeImages& before,
    const core::MaskFrame& frame, const Target& target)
    : m_cut(cut)
    , m_fields(fields)
    , m_before(before)
    , m_frame(frame)
    , m_target(target)
{
    m_cut.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("planePerI", round14(frame.planePerI))
        .set("planePerJ", round14(frame.planePerJ))
        .set("planePerK", round14(frame.planePerK))
        .set("pitch", frame.pitch)
        .set("rampHalfWidth", frame.rampHalfWidth)
        .set("refill", target.laying == core::Laying::Refill);
}

std::vector<std::uint32_t> ColumnCutter::bricksUnder(
    const std::vector<MaskColumns::PlaneBox>& boxes) const
{
    const core::BrickGrid& grid = m_fields.grid();
    const glm::ivec3 bricks = grid.bricks();
    // Plane → index, in doubles with margin: this only picks bricks that kernels then decide on.
    const glm::dmat3 indexToPlane{glm::dvec3(round14(m_frame.planePerI)),
        glm::dvec3(round14(m_frame.planePerJ)), glm::dvec3(round14(m_frame.planePerK))};
    const glm::dmat3 planeToIndex = glm::inverse(indexToPlane);
    const glm::dvec3 origin(core::planeBase(m_frame, glm::ivec3(0)));
    const glm::dvec3 halfBrick(core::BrickGrid::side / 2.0);
    glm::dvec3 brickReach(0.0);
    for (int axis = 0; axis < 3; ++axis)
        brickReach += glm::abs(indexToPlane[axis]) * (halfBrick.x + 1.0);

    std::set<std::uint32_t> found;
    for (const MaskColumns::PlaneBox& box : boxes) {
        glm::dvec3 low(std::numeric_limits<double>::max());
        glm::dvec3 high(std::numeric_limits<double>::lowest());
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 plane((corner & 1) ? box.maximum.x : box.minimum.x,
                (corner & 2) ? box.maximum.y : box.minimum.y,
                (corner & 4) ? box.maximum.z : box.minimum.z);
            const glm::dvec3 index = planeToIndex * (plane - origin);
            low = glm::min(low, index);
            high = glm::max(high, index);
        }
        const glm::ivec3 first =
            glm::clamp(glm::ivec3(glm::floor((low - 2.0) / 16.0)), glm::ivec3(0), bricks - 1);
        const glm::ivec3 last =
            glm::clamp(glm::ivec3(glm::floor((high + 2.0) / 16.0)), glm::ivec3(0), bricks - 1);
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x) {
                    const glm::dvec3 centre =
                        origin + indexToPlane * (glm::dvec3(x, y, z) * 16.0 + halfBrick);
                    const bool apart =
                        glm::any(glm::lessThan(centre + brickReach, glm::dvec3(box.minimum)))
                        || glm::any(glm::greaterThan(centre - brickReach, glm::dvec3(box.maximum)));
                    if (!apart)
                        found.insert(std::uint32_t(x + bricks.x * (y + bricks.y * z)));
                }
            }
        }
    }
    return {found.begin(), found.end()};
}

std::vector<std::uint32_t> ColumnCutter::lay(MaskColumns& columns)
{
    std::vector<std::uint32_t> candidates = bricksUnder(columns.takeChanged());
    BrickField& coverage = m_fields.coverage(m_target.layer);
    const auto isEmpty = [&](std::uint32_t brick) { return !coverage.holds(brick); };
    if (m_target.laying == core::Laying::Refill)
        std::erase_if(candidates, isEmpty); // there is nothing to fill
    if (candidates.empty())
        return {};
    std::vector<std::uint32_t> fresh;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(fresh), isEmpty);
    m_before.capture(core::Field::Coverage, m_target.layer, candidates);
    coverage.ensure(candidates);

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
    coverage.pageTable().bindUnit(1);
    coverage.atlas().bindImage(0, GL_READ_WRITE);
    baseBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    columns.bind(1, 2);
    changedBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    m_cut.set("firstTile", columns.firstTile()).set("tileCount", columns.tileCount());
    m_cut.dispatch({unsigned(candidates.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);

    std::vector<std::uint32_t> flags(candidates.size());
    changedBuffer.read(std::span<std::uint32_t>(flags));
    std::vector<std::uint32_t> changed;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (flags[i] != 0)
            changed.push_back(candidates[i]);
    }
    std::vector<std::uint32_t> unused;
    std::set_difference(
        fresh.begin(), fresh.end(), changed.begin(), changed.end(), std::back_inserter(unused));
    coverage.release(unused);
    m_touched.insert(changed.begin(), changed.end());
    return changed;
}

std::vector<std::uint32_t> ColumnCutter::touchedBricks() const
{
    return {m_touched.begin(), m_touched.end()};
}

} // namespace gpu

// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/ScissorsVoxels.h"

#include "core/brick/LabelBox.h"
#include "core/brick/RunRows.h"
#include "core/sculpt/labels/LabelScissors.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace core {

namespace {

using fixedPoint::floorDivide;
using fixedPoint::round14;

/// The voxels of a label as bits of the box around them, and which cells of 8³ have any.
class BoxOfVoxels {
public:
    BoxOfVoxels(const VoxelRuns& voxels, const glm::ivec3& volume)
        : m_box(boxOfRuns(voxels, volume))
        , m_size(m_box.maximum - m_box.minimum)
        , m_cells((m_size + (cellSide - 1)) / cellSide)
        , m_voxels(count(m_size), false)
        , m_filled(count(m_cells), false)
    {
        forEachRowPart(voxels, volume, [this](glm::ivec3 at, int ofRow, std::uint64_t) {
            at -= m_box.minimum;
            for (const int end = at.x + ofRow; at.x < end; ++at.x) {
                m_voxels[placeIn(m_size, at)] = true;
                m_filled[placeIn(m_cells, at / cellSide)] = true;
            }
        });
    }

    [[nodiscard]] const VoxelBox& box() const { return m_box; }
    /// @pre the voxel lies in the box
    [[nodiscard]] bool has(const glm::ivec3& voxel) const
    {
        return m_voxels[placeIn(m_size, voxel - m_box.minimum)];
    }
    /// How many samples of a ray from a place in the box on, half a voxel shifted, lie in its cell
    /// where that has no voxel; 0 where it has.
    [[nodiscard]] int emptySamples(const glm::ivec3& shifted, const glm::ivec3& step) const
    {
        const glm::ivec3 inBox = (shifted >> 16) - m_box.minimum;
        if (m_filled[placeIn(m_cells, inBox / cellSide)])
            return 0;
        constexpr int cell16 = cellSide << 16;
        int samples = cell16; // of the finest step
        for (int axis = 0; axis < 3; ++axis) {
            const int within = (shifted[axis] - (m_box.minimum[axis] << 16)) % cell16;
            if (step[axis] != 0)
                samples = std::min(samples,
                    (step[axis] > 0 ? cell16 - 1 - within : within) / std::abs(step[axis]) + 1);
        }
        return samples;
    }

private:
    static constexpr int cellSide = 8;
    static std::size_t count(const glm::ivec3& size)
    {
        return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    }
    static std::size_t placeIn(const glm::ivec3& size, const glm::ivec3& at)
    {
        return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
            + std::size_t(at.x);
    }

    VoxelBox m_box;
    glm::ivec3 m_size;
    glm::ivec3 m_cells;
    std::vector<bool> m_voxels;
    std::vector<bool> m_filled;
};

/// Rule 4 for one element: zSurface, or SurfaceHit::none.
std::int32_t surfaceUnder(
    const CutFrame& frame, const BoxOfVoxels& voxels, const glm::ivec2& element)
{
    constexpr std::int64_t farthest = std::int64_t(1) << 30; // core/sculpt/CutFrame.h, rule 2
    const glm::ivec3 step = round14(frame.rayPerSample);
    glm::ivec3 origin(0);
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = std::size_t(axis);
        const std::int64_t position = round14(
            frame.rayOrigin[i] + element.x * frame.rayPerA[i] + element.y * frame.rayPerB[i]);
        if (std::abs(position) > farthest)
            return SurfaceHit::none;
        origin[axis] = int(position);
    }
    const SeenSamples samples = samplesWithin(
        seenSamples(frame.hidden, origin, step, frame.sampleCount), origin, step, voxels.box());
    for (int n = samples.first; n < samples.end;) {
        const glm::ivec3 shifted = origin + n * step + (1 << 15);
        if (const int empty = voxels.emptySamples(shifted, step); empty > 0)
            n += empty;
        else if (voxels.has(shifted >> 16))
            return frame.zStart + n * frame.zPerSample;
        else
            ++n;
    }
    return SurfaceHit::none;
}

/// zSurface of each element of the mask.
Result<std::vector<std::int32_t>> surfacesUnder(const LabelScissors& scissors,
    const VoxelRuns& voxels, const glm::ivec3& size, const Progress& progress)
{
    const OutlineRaster& mask = scissors.mask;
    std::vector<std::int32_t> surfaces(mask.values.size(), SurfaceHit::none);
    const BoxOfVoxels box(voxels, size);
    std::size_t place = 0;
    for (int b = 0; b < mask.size.y; ++b) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        for (int a = 0; a < mask.size.x; ++a, ++place) {
            if (mask.values[place] >= LabelScissors::covered)
                surfaces[place] = surfaceUnder(scissors.frame, box, mask.first + glm::ivec2(a, b));
        }
    }
    return surfaces;
}

/// Rules 2 and 3 for voxels along a row of a brick.
class ChosenInRow {
public:
    ChosenInRow(const LabelScissors& scissors, const std::vector<std::int32_t>& reach)
        : m_scissors(scissors)
        , m_reach(reach)
        , m_perI(round14(scissors.frame.planePerI))
        , m_perJ(round14(scissors.frame.planePerJ))
        , m_perK(round14(scissors.frame.planePerK))
    {
    }

    /// @param at the first voxel; all lie in one row of one brick
    /// @param number that of the first voxel in the volume
    void operator()(const glm::ivec3& at, int voxels, std::uint64_t number, VoxelRuns& chosen) const
    {
        const glm::ivec3 within = at % BrickGrid::side;
        glm::ivec3 place = planeBase(m_scissors.frame, at - within) + within.x * m_perI
            + within.y * m_perJ + within.z * m_perK;
        for (int i = 0; i < voxels; ++i, place += m_perI) {
            const bool isMeant = isReached(place) != m_scissors.outside;
            if (isMeant && !isHidden({at.x + i, at.y, at.z}))
                chosen.append(number + std::uint64_t(i), 1);
        }
    }

private:
    [[nodiscard]] bool isReached(const glm::ivec3& place) const
    {
        const OutlineRaster& mask = m_scissors.mask;
        const int a = int(floorDivide(place.x, m_scissors.frame.pitch)) - mask.first.x;
        const int b = int(floorDivide(place.y, m_scissors.frame.pitch)) - mask.first.y;
        if (a < 0 || b < 0 || a >= mask.size.x || b >= mask.size.y)
            return false;
        const std::int32_t reach =
            m_reach[std::size_t(a) + std::size_t(mask.size.x) * std::size_t(b)];
        return reach != LabelScissors::nowhere && place.z <= reach;
    }
    [[nodiscard]] bool isHidden(const glm::ivec3& voxel) const
    {
        const std::vector<IntegerHalfSpace>& hidden = m_scissors.frame.hidden;
        return std::any_of(hidden.begin(), hidden.end(), [&voxel](const IntegerHalfSpace& half) {
            return std::int64_t(half.perVoxel.x) * voxel.x + std::int64_t(half.perVoxel.y) * voxel.y
                + std::int64_t(half.perVoxel.z) * voxel.z
                > half.offset;
        });
    }

    const LabelScissors& m_scissors;
    const std::vector<std::int32_t>& m_reach;
    glm::ivec3 m_perI;
    glm::ivec3 m_perJ;
    glm::ivec3 m_perK;
};

} // namespace

Result<VoxelRuns> chosenOf(const LabelScissors& scissors, const VoxelRuns& voxels,
    const glm::ivec3& size, const Progress& progress)
{
    std::vector<std::int32_t> surfaces;
    if (scissors.fromSurface) {
        Result<std::vector<std::int32_t>> found = surfacesUnder(scissors, voxels, size, progress);
        if (!found)
            return tl::unexpected(found.error());
        surfaces = *std::move(found);
    }
    const std::vector<std::int32_t> reach = scissorsReach(scissors, surfaces);
    const ChosenInRow choose(scissors, reach);
    VoxelRuns chosen;
    forEachRowPart(voxels, size, [&](glm::ivec3 at, int ofRow, std::uint64_t number) {
        for (const int end = at.x + ofRow; at.x < end && !progress.cancelled();) {
            const int ofBrick =
                std::min(end, (at.x / BrickGrid::side + 1) * BrickGrid::side) - at.x;
            choose(at, ofBrick, number, chosen);
            number += std::uint64_t(ofBrick);
            at.x += ofBrick;
        }
    });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return chosen;
}

} // namespace core

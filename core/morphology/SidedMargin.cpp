// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/SidedMargin.h"

#include "core/base/ParallelFor.h"
#include "core/brick/LabelBox.h"
#include "core/morphology/BoxRows.h"
#include "core/morphology/HalfEnvelope.h"
#include "core/morphology/StageCounter.h"
#include "core/volume/MemoryLimit.h"

#include <algorithm>
#include <array>
#include <vector>

namespace core {

namespace {

constexpr int sidedColumnsAtOnce = 16; ///< two lines of the processor's cache hold their sums
using Reaches = std::array<std::vector<std::uint16_t>, 2>;

/// One column of a slice: from what steps along x come to, how far its voxels reach along z.
class SidedColumn {
public:
    /// @param upTo what 0, 1, 2 … slices come to, backwards and forwards
    SidedColumn(const SidedBall& ball, const std::array<std::vector<std::int64_t>, 2>& upTo,
        std::size_t length)
        : m_ball(ball)
        , m_upTo(upTo)
        , m_sums(length)
        , m_least(length)
        , m_reach{std::vector<std::uint16_t>(length), std::vector<std::uint16_t>(length)}
    {
    }

    /// Along x, for each voxel; more than `whole`: unreachable.
    [[nodiscard]] std::vector<std::int64_t>& sums() { return m_sums; }
    /// One more than the number of slices that the rest of `whole` spans; 0: not even this slice.
    [[nodiscard]] const Reaches& reach() const { return m_reach; }

    void look()
    {
        const bool isReached = std::any_of(
            m_sums.begin(), m_sums.end(), [this](std::int64_t sum) { return sum <= m_ball.whole; });
        if (isReached) {
            m_least = m_sums;
            spread(1);
            spread(0);
        }
        for (std::size_t side = 0; side < 2; ++side) {
            if (isReached)
                findReach(side);
            else
                std::fill(m_reach.at(side).begin(), m_reach.at(side).end(), std::uint16_t(0));
        }
    }

private:
    /// @param side 1: from each place onwards; 0: backwards
    void spread(std::size_t side)
    {
        const std::int64_t curvature = m_ball.squared[1].at(side);
        if (curvature > m_ball.whole)
            return;
        const auto length = int(m_sums.size());
        m_envelope.clear(curvature);
        bool isBehindMask = false;
        for (int step = 0; step < length; ++step) {
            const auto y = std::size_t(side == 1 ? step : length - 1 - step);
            const std::int64_t sum = m_sums[y];
            if (sum == 0) { // of the mask: nothing is nearer
                isBehindMask = true;
                continue;
            }
            if (isBehindMask)
                m_envelope.add(step - 1, 0);
            isBehindMask = false;
            if (sum <= m_ball.whole)
                m_envelope.add(step, sum);
            if (!m_envelope.empty())
                m_least[y] = std::min(m_least[y], m_envelope.at(step));
        }
    }
    void findReach(std::size_t side)
    {
        const std::vector<std::int64_t>& upTo = m_upTo.at(side);
        std::size_t reach = 0; // hardly differs from that of the voxel before
        for (std::size_t y = 0; y < m_least.size(); ++y) {
            const std::int64_t rest = m_ball.whole - m_least[y];
            while (reach > 0 && upTo[reach - 1] > rest)
                --reach;
            while (reach < upTo.size() && upTo[reach] <= rest)
                ++reach;
            m_reach.at(side)[y] = std::uint16_t(reach);
        }
    }

    const SidedBall& m_ball;
    const std::array<std::vector<std::int64_t>, 2>& m_upTo;
    std::vector<std::int64_t> m_sums;
    std::vector<std::int64_t> m_least;
    Reaches m_reach;
    HalfEnvelope m_envelope;
};

/// Spreads a mask by the body, in place: along the rows of each slice, then along its columns, then
/// from slice to slice. Sums greater than `whole` count as unreachable.
class SidedSpread {
public:
    SidedSpread(ByteMask& mask, const SidedBall& ball)
        : m_mask(mask)
        , m_ball(ball)
        , m_reach{std::vector<std::uint16_t>(mask.voxels.size()),
              std::vector<std::uint16_t>(mask.voxels.size())}
    {
        for (std::size_t side = 0; side < 2; ++side) {
            const int most = side == 0 ? ball.before.x : ball.behind.x;
            for (std::int64_t steps = 0; steps <= most; ++steps)
                m_alongX.at(side).push_back(ball.squared[0].at(side) * steps * steps);
            m_alongX.at(side).push_back(ball.whole + 1);
            const std::int64_t step = ball.squared[2][side];
            for (std::int64_t slices = 0; slices < mask.size.z; ++slices) {
                if (step > ball.whole / std::max<std::int64_t>(1, slices * slices) && slices > 0)
                    break;
                m_upTo.at(side).push_back(step * slices * slices);
            }
        }
    }

    /// Independent for each z.
    void lookAlongSlice(int z)
    {
        const glm::ivec3& size = m_mask.size;
        std::vector<std::int64_t> sums(std::size_t(size.x) * std::size_t(size.y));
        bool any = false;
        for (int y = 0; y < size.y; ++y)
            any = measureRow(y, z, sums) || any;
        if (!any)
            return;
        std::vector<SidedColumn> columns(
            sidedColumnsAtOnce, SidedColumn(m_ball, m_upTo, std::size_t(size.y)));
        for (int x = 0; x < size.x; x += sidedColumnsAtOnce) {
            const auto width = std::size_t(std::min(sidedColumnsAtOnce, size.x - x));
            for (int y = 0; y < size.y; ++y) {
                const std::int64_t* row =
                    &sums[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
                for (std::size_t column = 0; column < width; ++column)
                    columns[column].sums()[std::size_t(y)] = row[column];
            }
            for (std::size_t column = 0; column < width; ++column)
                columns[column].look();
            for (std::size_t side = 0; side < 2; ++side) {
                for (int y = 0; y < size.y; ++y) {
                    std::uint16_t* row = &m_reach.at(side)[rowAt(y, z) + std::size_t(x)];
                    for (std::size_t column = 0; column < width; ++column)
                        row[column] = columns[column].reach().at(side)[std::size_t(y)];
                }
            }
        }
    }
    /// After all slices; independent for each y.
    void spreadAlongZ(int y)
    {
        const glm::ivec3& size = m_mask.size;
        const auto pass = [&](std::size_t side, int from, int to) {
            const std::uint16_t* source = &m_reach.at(side)[rowAt(y, from)];
            std::uint16_t* target = &m_reach.at(side)[rowAt(y, to)];
            for (int x = 0; x < size.x; ++x)
                target[x] = std::max(target[x], std::uint16_t(source[x] > 0 ? source[x] - 1 : 0));
        };
        // Where the body is flat no voxel reaches the next slice.
        for (int z = 1; z < size.z && m_upTo[1].size() > 1; ++z)
            pass(1, z - 1, z);
        for (int z = size.z - 1; z > 0 && m_upTo[0].size() > 1; --z)
            pass(0, z, z - 1);
        for (int z = 0; z < size.z; ++z) {
            const std::size_t row = rowAt(y, z);
            for (std::size_t x = 0; x < std::size_t(size.x); ++x)
                m_mask.voxels[row + x] = m_reach[0][row + x] > 0 || m_reach[1][row + x] > 0 ? 1 : 0;
        }
    }

private:
    [[nodiscard]] std::size_t rowAt(int y, int z) const
    {
        return (std::size_t(z) * std::size_t(m_mask.size.y) + std::size_t(y))
            * std::size_t(m_mask.size.x);
    }
    /// From the nearest voxels of the mask on both sides. @return whether the row has any
    bool measureRow(int y, int z, std::vector<std::int64_t>& sums) const
    {
        const std::uint8_t* row = &m_mask.voxels[rowAt(y, z)];
        std::int64_t* its = &sums[std::size_t(y) * std::size_t(m_mask.size.x)];
        const auto farForwards = m_alongX[1].size() - 1;
        std::size_t steps = farForwards;
        bool any = false;
        for (int x = 0; x < m_mask.size.x; ++x) {
            steps = row[x] != 0 ? 0 : std::min(steps + 1, farForwards);
            any = any || row[x] != 0;
            its[x] = m_alongX[1][steps];
        }
        if (!any)
            return false;
        const auto farBackwards = m_alongX[0].size() - 1;
        steps = farBackwards;
        for (int x = m_mask.size.x - 1; x >= 0; --x) {
            steps = row[x] != 0 ? 0 : std::min(steps + 1, farBackwards);
            its[x] = std::min(its[x], m_alongX[0][steps]);
        }
        return true;
    }

    ByteMask& m_mask;
    const SidedBall& m_ball;
    /// What 0, 1, 2 … steps along x come to, backwards and forwards; at the end what is too far.
    std::array<std::vector<std::int64_t>, 2> m_alongX;
    std::array<std::vector<std::int64_t>, 2> m_upTo; ///< of so many slices, as far as it matters
    Reaches m_reach;
};

/// Memory for a mask and its two reaches, and what is needed for single slices.
double spreadBytes(const glm::ivec3& size)
{
    const double slice = double(size.x) * double(size.y);
    constexpr double threads = 64.0;
    constexpr double bytes = 5.0;
    return bytes * slice * double(size.z) + 8.0 * slice * std::min(threads, double(size.z));
}

Result<void> spread(ByteMask& mask, const SidedBall& ball, const Progress& progress)
{
    const FilterStage stage{.progress = progress};
    StageCounter counter(stage, std::int64_t(mask.size.y) + mask.size.z);
    SidedSpread spreading(mask, ball);
    parallelFor(mask.size.z, [&](int z) {
        if (counter.cancelled())
            return;
        spreading.lookAlongSlice(z);
        counter.stepDone();
    });
    parallelFor(mask.size.y, [&](int y) {
        if (counter.cancelled())
            return;
        spreading.spreadAlongZ(y);
        counter.stepDone();
    });
    if (counter.cancelled())
        return failure(ErrorCode::Cancelled);
    return {};
}

} // namespace

Result<ShapeChange> sidedMarginChange(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, bool grows, const SidedBall& ball, const Progress& progress)
{
    const VoxelBox own = boxOfLabel(labels, size, label);
    if (own.empty())
        return ShapeChange();
    // To shrink, voxels outside the segment are looked for in its box and a rim of one voxel around
    // it. Beyond that, for every such voxel there is one in the rim that is reached by shorter
    // steps to the same sides.
    const glm::ivec3 before = grows ? ball.before : glm::ivec3(1);
    const glm::ivec3 behind = grows ? ball.behind : glm::ivec3(1);
    const BoxRows rows({.minimum = glm::max(own.minimum - before, glm::ivec3(0)),
                           .maximum = glm::min(own.maximum + behind, size)},
        size, progress);
    if (const Result<void> enough =
            checkBytes(spreadBytes(rows.boxSize()), Clause::saying("the segment with this margin"));
        !enough)
        return tl::unexpected(enough.error());
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    ByteMask mask = rows.mask(labels, label, grows);
    // A voxel is lost if the body around it reaches a voxel outside; seen from the latter, the step
    // is the opposite one.
    if (const Result<void> done = spread(mask, grows ? ball : reversed(ball), progress); !done)
        return tl::unexpected(done.error());
    const auto isReached = [&](std::size_t voxel) { return mask.voxels[voxel] != 0; };
    ShapeChange change;
    if (grows)
        change.given = rows.voxels(labels, 0, isReached);
    else
        change.taken = rows.voxels(labels, label, isReached);
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return change;
}

} // namespace core

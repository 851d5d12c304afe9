// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/SidedMargin.h"

#include "core/base/ParallelFor.h"
#include "core/brick/LabelBox.h"
#include "core/morphology/BoxRows.h"
#include "core/morphology/StageCounter.h"
#include "core/volume/MemoryLimit.h"

#include <algorithm>
#include <array>
#include <vector>

namespace core {

namespace {

/// The least sum of a squared distance across a line, which is known at each place, and the square
/// of the steps along it, taken in one direction only. Each place thus contributes half a parabola
/// that begins there. Two of these meet once at most, and from there on the later one is lower, so
/// they form an envelope as in LowerEnvelope.
class HalfEnvelope {
public:
    void clear(std::int64_t curvature)
    {
        m_curvature = curvature;
        m_parabolas.clear();
    }
    /// The value at the place to which moveTo() went last.
    [[nodiscard]] std::int64_t at(int place) const
    {
        const Parabola& lowest = m_parabolas[m_lowest];
        const std::int64_t step = place - lowest.place;
        return lowest.least + m_curvature * step * step;
    }
    [[nodiscard]] bool empty() const { return m_parabolas.empty(); }
    void add(int place, std::int64_t least)
    {
        int from = place;
        while (!m_parabolas.empty()) {
            const Parabola& last = m_parabolas.back();
            const std::int64_t apart = place - last.place;
            const std::int64_t meet = dividedUp(
                least - last.least + m_curvature * apart * (std::int64_t(place) + last.place),
                2 * m_curvature * apart);
            from = int(std::clamp<std::int64_t>(meet, place, never));
            if (from > last.from)
                break;
            m_parabolas.pop_back();
            from = place;
        }
        if (from < never)
            m_parabolas.push_back({.place = place, .from = from, .least = least});
    }
    /// Selects the parabola that is lowest at a place.
    void moveTo(int place)
    {
        m_lowest = std::min(m_lowest, m_parabolas.size() - 1);
        while (m_lowest + 1 < m_parabolas.size() && m_parabolas[m_lowest + 1].from <= place)
            ++m_lowest;
        while (m_lowest > 0 && m_parabolas[m_lowest].from > place)
            --m_lowest;
    }

private:
    struct Parabola {
        int place = 0;
        int from = 0; ///< the first place at which it is the lowest
        std::int64_t least = 0;
    };
    static constexpr std::int64_t never = std::int64_t(1) << 30;

    /// @param divisor positive
    [[nodiscard]] static std::int64_t dividedUp(std::int64_t number, std::int64_t divisor)
    {
        return number / divisor + (number % divisor > 0 ? 1 : 0);
    }

    std::int64_t m_curvature = 1;
    std::size_t m_lowest = 0;
    std::vector<Parabola> m_parabolas;
};

/// Spreads a mask by the body, in place: along the rows of each slice, then along its columns, then
/// from slice to slice. Sums greater than `whole` count as unreachable.
class SidedSpread {
public:
    SidedSpread(ByteMask& mask, const SidedBall& ball)
        : m_mask(mask)
        , m_ball(ball)
        , m_none(ball.whole + 1)
        , m_reach{std::vector<std::uint16_t>(mask.voxels.size()),
              std::vector<std::uint16_t>(mask.voxels.size())}
    {
        for (std::size_t side = 0; side < 2; ++side) {
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
        std::vector<std::int64_t> column(static_cast<std::size_t>(size.y));
        std::vector<std::int64_t> least(column.size());
        HalfEnvelope envelope;
        for (int x = 0; x < size.x; ++x) {
            for (int y = 0; y < size.y; ++y)
                column[std::size_t(y)] =
                    sums[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
            least = column;
            spreadAlong(column, least, 1, envelope);
            spreadAlong(column, least, 0, envelope);
            for (int y = 0; y < size.y; ++y) {
                const std::size_t voxel = rowAt(y, z) + std::size_t(x);
                m_reach[0][voxel] = reachOf(0, least[std::size_t(y)]);
                m_reach[1][voxel] = reachOf(1, least[std::size_t(y)]);
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
        for (int z = 1; z < size.z; ++z)
            pass(1, z - 1, z);
        for (int z = size.z - 1; z > 0; --z)
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
    /// The squared share of the margin that a number of steps to one side of an axis has.
    [[nodiscard]] std::int64_t squaredAlong(int axis, std::size_t side, int steps) const
    {
        const int most = side == 0 ? m_ball.before[axis] : m_ball.behind[axis];
        if (steps > most)
            return m_none;
        const std::int64_t its = steps;
        return std::min(m_none, m_ball.squared.at(std::size_t(axis)).at(side) * its * its);
    }
    /// From the nearest voxels of the mask on both sides. @return whether the row has any
    bool measureRow(int y, int z, std::vector<std::int64_t>& sums) const
    {
        const std::uint8_t* row = &m_mask.voxels[rowAt(y, z)];
        std::int64_t* its = &sums[std::size_t(y) * std::size_t(m_mask.size.x)];
        const int far = m_mask.size.x + 1;
        int steps = far;
        bool any = false;
        for (int x = 0; x < m_mask.size.x; ++x) {
            steps = row[x] != 0 ? 0 : std::min(steps + 1, far);
            any = any || row[x] != 0;
            its[x] = squaredAlong(0, 1, steps);
        }
        steps = far;
        for (int x = m_mask.size.x - 1; x >= 0; --x) {
            steps = row[x] != 0 ? 0 : std::min(steps + 1, far);
            its[x] = std::min(its[x], squaredAlong(0, 0, steps));
        }
        return any;
    }
    /// @param side 1: from each place onwards; 0: backwards
    void spreadAlong(const std::vector<std::int64_t>& column, std::vector<std::int64_t>& least,
        std::size_t side, HalfEnvelope& envelope) const
    {
        const std::int64_t curvature = m_ball.squared[1].at(side);
        if (curvature > m_ball.whole)
            return;
        const auto length = int(column.size());
        envelope.clear(curvature);
        for (int step = 0; step < length; ++step) {
            const auto y = std::size_t(side == 1 ? step : length - 1 - step);
            if (column[y] < m_none)
                envelope.add(step, column[y]);
            if (envelope.empty())
                continue;
            envelope.moveTo(step);
            least[y] = std::min(least[y], envelope.at(step));
        }
    }
    /// One more than the number of slices that the rest of `whole` spans; 0: not even this slice.
    [[nodiscard]] std::uint16_t reachOf(std::size_t side, std::int64_t sum) const
    {
        const std::vector<std::int64_t>& upTo = m_upTo.at(side);
        return std::uint16_t(
            std::upper_bound(upTo.begin(), upTo.end(), m_ball.whole - sum) - upTo.begin());
    }

    ByteMask& m_mask;
    const SidedBall& m_ball;
    std::int64_t m_none;
    std::array<std::vector<std::int64_t>, 2> m_upTo; ///< of so many slices, as far as it matters
    std::array<std::vector<std::uint16_t>, 2> m_reach;
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

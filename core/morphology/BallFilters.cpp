// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/BallFilters.h"

#include "core/base/ParallelFor.h"
#include "core/morphology/MaskDilation.h"
#include "core/morphology/MillimetreBall.h"
#include "core/morphology/StageCounter.h"

#include <algorithm>

namespace core {

namespace {

/// Counts the voxels of a mask in the ball around each voxel. The voxels of each row are summed
/// from its beginning, so that a row of the ball costs only two of these sums.
class CountInBall {
public:
    CountInBall(ByteMask& mask, const MillimetreBall& ball)
        : m_mask(mask)
        , m_rows(ballRows(ball, mask.size))
        , m_width(std::size_t(mask.size.x))
        , m_before((m_width + 1) * std::size_t(mask.size.y) * std::size_t(mask.size.z))
    {
    }

    [[nodiscard]] int rows() const { return m_mask.size.y * m_mask.size.z; }
    void addUp(int row)
    {
        const std::uint8_t* voxels = &m_mask.voxels[std::size_t(row) * m_width];
        std::uint16_t* before = &m_before[std::size_t(row) * (m_width + 1)];
        for (std::size_t x = 0; x < m_width; ++x)
            before[x + 1] = std::uint16_t(before[x] + voxels[x]);
    }
    /// Sets those voxels of a row that have at least this many voxels of the mask in the ball. To
    /// be called after addUp() for all rows.
    void choose(int row, std::int64_t atLeast, const StageCounter& counter)
    {
        const int y = row % m_mask.size.y;
        const int z = row / m_mask.size.y;
        std::vector<std::int64_t> counts(m_width, 0);
        constexpr int betweenLooks = 4096;
        int looks = 0;
        for (const BallRow& each : m_rows) {
            if (++looks % betweenLooks == 0 && counter.cancelled())
                return;
            const int otherY = y + each.y;
            const int otherZ = z + each.z;
            if (otherY < 0 || otherY >= m_mask.size.y || otherZ < 0 || otherZ >= m_mask.size.z)
                continue;
            const std::uint16_t* before =
                &m_before[std::size_t(otherZ * m_mask.size.y + otherY) * (m_width + 1)];
            if (before[m_width] == 0)
                continue;
            addShifted(counts, before, each.to + 1, 1);
            addShifted(counts, before, each.from, -1);
        }
        std::uint8_t* voxels = &m_mask.voxels[std::size_t(row) * m_width];
        for (std::size_t x = 0; x < m_width; ++x)
            voxels[x] = counts[x] >= atLeast ? 1 : 0;
    }

private:
    /// Adds before[x + shift] to counts[x]. Before the row the sum is 0, behind it that of the
    /// whole row.
    void addShifted(std::vector<std::int64_t>& counts, const std::uint16_t* before, int shift,
        std::int64_t sign) const
    {
        const auto width = std::ptrdiff_t(m_width);
        const std::ptrdiff_t begin = std::clamp<std::ptrdiff_t>(-shift, 0, width);
        const std::ptrdiff_t end = std::clamp<std::ptrdiff_t>(width - shift, 0, width);
        for (std::ptrdiff_t x = begin; x < end; ++x)
            counts[std::size_t(x)] += sign * before[x + shift];
        for (std::ptrdiff_t x = end; x < width; ++x)
            counts[std::size_t(x)] += sign * before[width];
    }

    ByteMask& m_mask;
    std::vector<BallRow> m_rows;
    std::size_t m_width;
    std::vector<std::uint16_t> m_before; ///< voxels of the mask in its row before each, and in all
};

Result<void> keepCounted(
    ByteMask& mask, const MillimetreBall& ball, std::int64_t atLeast, const FilterStage& stage)
{
    CountInBall count(mask, ball);
    StageCounter counter(stage, count.rows());
    parallelFor(count.rows(), [&](int row) { count.addUp(row); });
    parallelFor(count.rows(), [&](int row) {
        if (counter.cancelled())
            return;
        count.choose(row, atLeast, counter);
        counter.stepDone();
    });
    if (counter.cancelled())
        return failure(ErrorCode::Cancelled);
    return {};
}

} // namespace

namespace {

/// Finds what is not enclosed, run by run along x.
class OutsideFlood {
public:
    explicit OutsideFlood(ByteMask& mask)
        : m_mask(mask)
    {
        for (int z = 0; z < mask.size.z; ++z) {
            for (int y = 0; y < mask.size.y; ++y) {
                const bool isBorderRow =
                    y == 0 || z == 0 || y == mask.size.y - 1 || z == mask.size.z - 1;
                for (int x = 0; x < mask.size.x;
                     x += isBorderRow ? 1 : std::max(1, mask.size.x - 1))
                    wait({x, y, z});
            }
        }
    }

    [[nodiscard]] bool isDone() const { return m_waiting.empty(); }
    void step()
    {
        const glm::ivec3 at = m_waiting.back();
        m_waiting.pop_back();
        if (voxel(at) != 0)
            return;
        int begin = at.x;
        int end = at.x + 1;
        while (begin > 0 && voxel({begin - 1, at.y, at.z}) == 0)
            --begin;
        while (end < m_mask.size.x && voxel({end, at.y, at.z}) == 0)
            ++end;
        std::fill_n(&voxel({begin, at.y, at.z}), end - begin, outside);
        for (const glm::ivec2& step :
            {glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, -1), glm::ivec2(0, 1)})
            lookAlong(begin, end, at.y + step.x, at.z + step.y);
    }
    /// What the flood has not reached is set.
    void settle()
    {
        for (std::uint8_t& each : m_mask.voxels)
            each = each == outside ? 0 : 1;
    }

private:
    static constexpr std::uint8_t outside = 2;

    [[nodiscard]] std::uint8_t& voxel(const glm::ivec3& at)
    {
        return m_mask.voxels[(std::size_t(at.z) * std::size_t(m_mask.size.y) + std::size_t(at.y))
                * std::size_t(m_mask.size.x)
            + std::size_t(at.x)];
    }
    void wait(const glm::ivec3& at)
    {
        if (voxel(at) == 0)
            m_waiting.push_back(at);
    }
    /// The first voxel of each run of a neighbouring row waits.
    void lookAlong(int begin, int end, int y, int z)
    {
        if (y < 0 || z < 0 || y >= m_mask.size.y || z >= m_mask.size.z)
            return;
        bool isRun = false;
        for (int x = begin; x < end; ++x) {
            const bool isFree = voxel({x, y, z}) == 0;
            if (isFree && !isRun)
                m_waiting.emplace_back(x, y, z);
            isRun = isFree;
        }
    }

    ByteMask& m_mask;
    std::vector<glm::ivec3> m_waiting;
};

} // namespace

double filterBytes(const glm::ivec3& size)
{
    const double rows = double(size.y) * double(size.z);
    return 3.0 * double(size.x) * rows + 2.0 * rows;
}

Result<void> dilate(ByteMask& mask, const MillimetreBall& ball, const FilterStage& stage)
{
    if (!ball.isStraight())
        return keepCounted(mask, ball, 1, stage);
    MaskDilation reach(mask, ball);
    StageCounter counter(stage, std::int64_t(mask.size.y) + mask.size.z);
    parallelFor(mask.size.z, [&](int z) {
        if (counter.cancelled())
            return;
        reach.lookAlongSlice(z);
        counter.stepDone();
    });
    parallelFor(mask.size.y, [&](int y) {
        if (counter.cancelled())
            return;
        reach.spreadAlongZ(y);
        counter.stepDone();
    });
    if (counter.cancelled())
        return failure(ErrorCode::Cancelled);
    return {};
}

Result<void> keepMajority(ByteMask& mask, const MillimetreBall& ball, const FilterStage& stage)
{
    return keepCounted(mask, ball, voxelCount(ball) / 2 + 1, stage);
}

Result<void> fillEnclosed(ByteMask& mask, const Progress& progress)
{
    OutsideFlood flood(mask);
    constexpr int betweenLooks = 1024;
    for (int steps = 0; !flood.isDone(); ++steps) {
        if (steps % betweenLooks == 0 && progress.cancelled())
            return failure(ErrorCode::Cancelled);
        flood.step();
    }
    flood.settle();
    return {};
}

} // namespace core

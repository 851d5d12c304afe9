// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/MaskDilation.h"

#include "core/morphology/LowerEnvelope.h"

#include <algorithm>

namespace core {

namespace {

constexpr int columnsAtOnce = 16; ///< a line of the processor's cache holds them

/// The reach of the voxels of one column, along y, from their distances along x.
class Column {
public:
    Column(const MillimetreBall& ball, const std::vector<std::int64_t>& upTo, int length)
        : m_ball(ball)
        , m_upTo(upTo)
        , m_steps(std::size_t(length))
        , m_reach(std::size_t(length))
        , m_envelope(ball.yy, std::size_t(length))
    {
    }

    [[nodiscard]] std::vector<int>& steps() { return m_steps; } ///< more than the extent: none
    [[nodiscard]] const std::vector<std::uint16_t>& reach() const { return m_reach; }

    void look()
    {
        const auto length = int(m_steps.size());
        for (int y = 0; y < length;) {
            int end = y;
            while (end < length && m_steps[std::size_t(end)] == 0)
                ++end;
            std::fill(m_reach.begin() + y, m_reach.begin() + end, std::uint16_t(m_upTo.size()));
            y = end;
            while (end < length && m_steps[std::size_t(end)] != 0)
                ++end;
            lookBetween(y, end);
            y = end;
        }
    }

private:
    /// Voxels from @p begin to @p end are not of the mask, those beside them are, or there are
    /// none: no voxel beyond is nearer.
    void lookBetween(int begin, int end)
    {
        m_envelope.clear(begin, end);
        const auto length = int(m_steps.size());
        for (int y = std::max(0, begin - 1); y < std::min(length, end + 1); ++y) {
            const std::int64_t step = m_steps[std::size_t(y)];
            const std::int64_t least = m_ball.xx * step * step;
            if (step <= m_ball.extent.x && least <= m_ball.squaredRadius)
                m_envelope.add(y, least);
        }
        if (m_envelope.empty()) {
            std::fill(m_reach.begin() + begin, m_reach.begin() + end, std::uint16_t(0));
            return;
        }
        std::size_t reach = 0;
        for (int y = begin; y < end; ++y) {
            reach = reachWith(m_ball.squaredRadius - m_envelope.at(y), reach);
            m_reach[std::size_t(y)] = std::uint16_t(reach);
        }
    }
    /// @param rest of the squared radius
    /// @param near the neighbour's reach, from which it hardly differs
    [[nodiscard]] std::size_t reachWith(std::int64_t rest, std::size_t near) const
    {
        while (near > 0 && m_upTo[near - 1] > rest)
            --near;
        while (near < m_upTo.size() && m_upTo[near] <= rest)
            ++near;
        return near;
    }

    const MillimetreBall& m_ball;
    const std::vector<std::int64_t>& m_upTo;
    std::vector<int> m_steps;
    std::vector<std::uint16_t> m_reach;
    LowerEnvelope m_envelope;
};

} // namespace

MaskDilation::MaskDilation(ByteMask& mask, const MillimetreBall& ball)
    : m_mask(mask)
    , m_ball(ball)
    , m_reach(mask.voxels.size())
{
    for (std::int64_t slices = 0; slices < mask.size.z; ++slices) {
        const std::int64_t squared = ball.zz * slices * slices;
        if (squared > ball.squaredRadius)
            break;
        m_upTo.push_back(squared);
    }
}

/// Steps along x to the nearest voxel of the mask, at most one more than the extent.
/// @return whether the slice has any
bool MaskDilation::measureRows(int z, std::vector<int>& steps) const
{
    const int none = m_ball.extent.x + 1;
    bool any = false;
    for (int y = 0; y < m_mask.size.y; ++y) {
        const std::uint8_t* row = &m_mask.voxels[rowAt(y, z)];
        int* its = &steps[std::size_t(y) * std::size_t(m_mask.size.x)];
        int last = none;
        for (int x = 0; x < m_mask.size.x; ++x) {
            last = row[x] != 0 ? 0 : std::min(last + 1, none);
            its[x] = last;
            any = any || row[x] != 0;
        }
        last = none;
        for (int x = m_mask.size.x - 1; x >= 0; --x) {
            last = std::min(its[x], std::min(last + 1, none));
            its[x] = last;
        }
    }
    return any;
}

void MaskDilation::lookAlongSlice(int z)
{
    const glm::ivec3& size = m_mask.size;
    std::vector<int> steps(std::size_t(size.x) * std::size_t(size.y));
    if (!measureRows(z, steps))
        return; // no voxel of it reaches anything
    std::vector<Column> columns(columnsAtOnce, Column(m_ball, m_upTo, size.y));
    for (int x = 0; x < size.x; x += columnsAtOnce) {
        const int width = std::min(columnsAtOnce, size.x - x);
        for (int y = 0; y < size.y; ++y) {
            const int* row = &steps[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
            for (int column = 0; column < width; ++column)
                columns[std::size_t(column)].steps()[std::size_t(y)] = row[column];
        }
        for (int column = 0; column < width; ++column)
            columns[std::size_t(column)].look();
        for (int y = 0; y < size.y; ++y) {
            std::uint16_t* row = &m_reach[rowAt(y, z) + std::size_t(x)];
            for (int column = 0; column < width; ++column)
                row[column] = columns[std::size_t(column)].reach()[std::size_t(y)];
        }
    }
}

void MaskDilation::spreadAlongZ(int y)
{
    const glm::ivec3& size = m_mask.size;
    const auto spread = [&](int from, int to) {
        const std::uint16_t* source = &m_reach[rowAt(y, from)];
        std::uint16_t* target = &m_reach[rowAt(y, to)];
        for (int x = 0; x < size.x; ++x) {
            const auto left = std::uint16_t(source[x] > 0 ? source[x] - 1 : 0);
            target[x] = std::max(target[x], left);
        }
    };
    for (int z = 1; z < size.z; ++z)
        spread(z - 1, z);
    for (int z = size.z - 1; z > 0; --z)
        spread(z, z - 1);
    for (int z = 0; z < size.z; ++z) {
        const std::size_t row = rowAt(y, z);
        for (std::size_t x = 0; x < std::size_t(size.x); ++x)
            m_mask.voxels[row + x] = m_reach[row + x] > 0 ? 1 : 0;
    }
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/sculpt/ElementPlane.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

namespace reference {

namespace {

std::int64_t round14(std::int64_t value)
{
    return (value + (1 << 13)) >> 14;
}

std::int64_t ramp(std::int64_t t, std::int64_t halfWidth)
{
    return (std::clamp(t, -halfWidth, halfWidth) + halfWidth) * 255 / (2 * halfWidth);
}

} // namespace

std::int64_t floorDivide(std::int64_t value, std::int64_t divisor)
{
    const std::int64_t quotient = value / divisor;
    return quotient * divisor > value ? quotient - 1 : quotient;
}

std::int64_t squareRoot(std::int64_t value)
{
    // One bit of the root after the other, as by hand: what remains is compared to what the square
    // grows by, so that nothing is divided or multiplied.
    auto remainder = std::uint64_t(value);
    std::uint64_t root = 0; // times the bit, so that it is shifted down on the way
    for (std::uint64_t square = std::uint64_t(1) << (std::bit_width(remainder | 1) - 1) / 2 * 2;
         square > 0; square >>= 2) {
        const std::uint64_t growth = root + square;
        root >>= 1;
        if (remainder < growth)
            continue;
        remainder -= growth;
        root += square;
    }
    return std::int64_t(root);
}

ElementPlane::ElementPlane(const DenseArray<std::uint16_t>& codes,
    DenseArray<std::uint8_t> radiation, DenseFields& fields, std::uint8_t layer,
    core::CutFrame frame)
    : m_codes(codes)
    , m_radiation(std::move(radiation))
    , m_coverage(fields.coverage(layer))
    , m_protected(fields, frame.protectedLabels)
    , m_frame(frame)
{
}

std::optional<ElementPlane::Hit> ElementPlane::cast(std::int64_t a, std::int64_t b)
{
    std::optional<std::int32_t> end;
    const std::optional<Hit> hit = hitOf(a, b);
    if (hit && !m_frame.restore) {
        end = std::int32_t(hit->zSurface);
    } else {
        for (std::int64_t n = 0; n < m_frame.sampleCount; ++n) {
            bool inside = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::int64_t start = round14(m_frame.rayOrigin[axis]
                    + a * m_frame.rayPerA[axis] + b * m_frame.rayPerB[axis]);
                const std::int64_t at = start + n * round14(m_frame.rayPerSample[axis]);
                inside = inside && at >= -32768
                    && at < (2 * std::int64_t(m_codes.size[int(axis)]) - 1) * 32768;
            }
            if (inside)
                end = std::int32_t(m_frame.zStart + n * m_frame.zPerSample);
        }
    }
    m_searchedTo = std::max(m_searchedTo, end);
    return hit;
}

std::optional<ElementPlane::Hit> ElementPlane::hitOf(std::int64_t a, std::int64_t b)
{
    const Tissue tissue{m_codes, m_radiation, m_frame.restore, m_frame.asWhole};
    Index16 start;
    Index16 step;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        start[axis] = round14(
            m_frame.rayOrigin[axis] + a * m_frame.rayPerA[axis] + b * m_frame.rayPerB[axis]);
        step[axis] = round14(m_frame.rayPerSample[axis]);
    }
    const auto placeAt = [&](std::int64_t n, std::int64_t q) {
        Index16 position;
        for (std::size_t axis = 0; axis < 3; ++axis)
            position[axis] = start[axis] + n * step[axis] + ((q * step[axis]) >> 4);
        return position;
    };
    const auto materialAt = [&](std::int64_t n, std::int64_t q) {
        return tissue.material(placeAt(n, q), m_frame.thresholdCode);
    };
    const auto hollowAt = [&](std::int64_t n, std::int64_t q) {
        const Index16 position = placeAt(n, q);
        return tissue.inside(position) && tissue.dense(position, m_frame.thresholdCode)
            && tissue.carved(position);
    };
    const auto seenAt = [&](std::int64_t n) {
        return !hidesPosition(m_frame.hidden, placeAt(n, 0));
    };
    const auto height = [&](std::int64_t n, std::int64_t q) {
        return m_frame.zStart + n * m_frame.zPerSample + ((q * m_frame.zPerSample) >> 4);
    };

    // Where a test that fails at `before` and holds at `after`, in sixteenths, begins to hold.
    const auto turnsTrue = [](std::int64_t before, std::int64_t after, const auto& holds) {
        for (int bisection = 0; bisection < 4; ++bisection) {
            const std::int64_t middle = (before + after) / 2;
            (holds(middle / 16, middle % 16) ? after : before) = middle;
        }
        return after;
    };
    for (const std::int64_t coordinate : start) {
        if (std::abs(coordinate) > std::int64_t(1) << 30)
            return std::nullopt;
    }

    std::int64_t begin = 0;
    while (begin < m_frame.sampleCount && !seenAt(begin))
        ++begin;
    std::int64_t end = begin;
    while (end < m_frame.sampleCount && seenAt(end))
        ++end;
    std::int64_t first = begin;
    while (first < end && !materialAt(first, 0))
        ++first;
    if (m_frame.restore) {
        std::int64_t last = first - 1;
        while (last >= begin && !hollowAt(last, 0))
            --last;
        if (last >= begin) {
            std::int64_t outer = last;
            while (outer > begin && hollowAt(outer - 1, 0))
                --outer;
            const std::int64_t wall = turnsTrue(last * 16, (last + 1) * 16,
                [&](std::int64_t n, std::int64_t q) { return !hollowAt(n, q); });
            const std::int64_t rim =
                outer > begin ? turnsTrue((outer - 1) * 16, outer * 16, hollowAt) : outer * 16;
            return Hit{height(wall / 16, wall % 16), height(rim / 16, rim % 16)};
        }
        if (first >= end)
            return std::nullopt;
        for (std::int64_t n = first - 1;
             n >= begin && height(first, 0) - height(n, 0) <= 2 * m_frame.front; --n) {
            const Index16 position = placeAt(n, 0);
            if (tissue.inside(position) && tissue.carved(position))
                return Hit{height(first, 0), height(first, 0)};
        }
        return std::nullopt;
    }
    if (first >= end)
        return std::nullopt;

    const std::int64_t met =
        first > begin ? turnsTrue((first - 1) * 16, first * 16, materialAt) : first * 16;
    Hit hit{height(met / 16, met % 16), never};
    if (m_frame.throughGaps)
        return hit;
    int run = 0;
    for (std::int64_t n = first + 1; n < end && height(n, 0) <= hit.zSurface + m_frame.maxDepth;
         ++n) {
        run = materialAt(n, 0) ? 0 : run + 1;
        if (run == m_frame.gapSamples) {
            hit.zExit = height(n - run + 1, 0);
            break;
        }
    }
    return hit;
}

ElementPlane::Column ElementPlane::restoring(
    const Hit& hit, std::int64_t from, std::int64_t weight) const
{
    const std::int64_t r = m_frame.rampHalfWidth;
    from = std::min(from, hit.zSurface - floorDivide(m_frame.front, 2) - r);
    if (from <= hit.zExit + m_frame.front - floorDivide(r, 8))
        from = hit.zExit - 2 * m_frame.front - 2 * r;
    return {from, hit.zSurface + floorDivide(m_frame.front, 2) + r, weight};
}

std::uint8_t refilled(std::uint8_t coverage, std::uint8_t cut)
{
    const int left = std::min<int>(coverage, 255 - cut);
    return std::uint8_t(left > cut ? left : 0);
}

void ElementPlane::lay(const std::map<Place, Column>& columns, core::Laying laying)
{
    const core::BrickGrid grid{m_codes.size};
    std::array<std::int64_t, 3> perI;
    std::array<std::int64_t, 3> perJ;
    std::array<std::int64_t, 3> perK;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        perI[axis] = round14(m_frame.planePerI[axis]);
        perJ[axis] = round14(m_frame.planePerJ[axis]);
        perK[axis] = round14(m_frame.planePerK[axis]);
    }
    const std::int64_t r = m_frame.rampHalfWidth;
    for (int brick = 0; brick < grid.brickCount(); ++brick) {
        const core::VoxelBox box = grid.boxOf(brick);
        const glm::ivec3 o = box.minimum;
        std::array<std::int64_t, 3> base;
        for (std::size_t axis = 0; axis < 3; ++axis)
            base[axis] = round14(m_frame.planeOrigin[axis] + o.x * m_frame.planePerI[axis]
                + o.y * m_frame.planePerJ[axis] + o.z * m_frame.planePerK[axis]);
        for (int k = 0; k < box.maximum.z - o.z; ++k) {
            for (int j = 0; j < box.maximum.y - o.y; ++j) {
                for (int i = 0; i < box.maximum.x - o.x; ++i) {
                    const auto plane = [&](std::size_t axis) {
                        return base[axis] + i * perI[axis] + j * perJ[axis] + k * perK[axis];
                    };
                    const auto column = columns.find({floorDivide(plane(0), m_frame.pitch),
                        floorDivide(plane(1), m_frame.pitch)});
                    if (column == columns.end()
                        || hidesVoxel(m_frame.hidden, o + glm::ivec3(i, j, k)))
                        continue;
                    if (laying == core::Laying::Carve && m_protected.hold(o + glm::ivec3(i, j, k)))
                        continue;
                    const Column& c = column->second;
                    const std::int64_t z = plane(2);
                    const auto cut = std::uint8_t(
                        std::min({c.weight, ramp(c.zTo - z, r), ramp(z - c.zFrom, r)}));
                    std::uint8_t& coverage = m_coverage.at(o + glm::ivec3(i, j, k));
                    coverage = laying == core::Laying::Carve ? std::max(coverage, cut)
                                                             : refilled(coverage, cut);
                }
            }
        }
    }
}

} // namespace reference

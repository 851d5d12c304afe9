// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/sculpt/Capsules.h"

#include "core/growth/SeedWord.h"
#include "tests/reference/growth/Growth.h"
#include "tests/reference/sculpt/ElementPlane.h"
#include "tests/reference/sculpt/LayerWrites.h"
#include "tests/reference/sculpt/ProtectedVoxels.h"
#include "tests/reference/sculpt/Rays.h"

#include <algorithm>
#include <utility>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

using Position = std::array<std::int64_t, 3>;

std::int64_t round14(std::int64_t value)
{
    return (value + 8192) >> 14;
}

/// numerator / denominator; the latter is above 0.
struct Fraction {
    std::int64_t numerator;
    std::int64_t denominator;

    bool operator<(const Fraction& other) const
    {
        return numerator * other.denominator < other.numerator * denominator;
    }
};

/// Whether a box of this half side around some point of the line from 0 along u holds q. A point at
/// t of the line is t·u / 2¹⁴; the box holds q in one component while t is in some interval.
bool isInBox(
    const Position& q, const core::Capsule& capsule, std::int64_t length, std::int64_t half)
{
    Fraction from{0, 1};
    Fraction to{length, 1};
    for (int c = 0; c < 3; ++c) {
        std::int64_t u = capsule.direction[c];
        std::int64_t enters = (q[std::size_t(c)] - half) * 16384;
        std::int64_t leaves = (q[std::size_t(c)] + half) * 16384;
        if (u == 0) {
            if (enters > 0 || leaves < 0)
                return false;
            continue;
        }
        if (u < 0) {
            u = -u;
            std::swap(enters, leaves);
            enters = -enters;
            leaves = -leaves;
        }
        from = std::max(from, Fraction{enters, u});
        to = std::min(to, Fraction{leaves, u});
    }
    return !(to < from);
}

/// The least such half side, or @p low where it is less, @p high where it is more.
std::int64_t leastBox(const Position& q, const core::Capsule& capsule, std::int64_t length,
    std::int64_t low, std::int64_t high)
{
    if (isInBox(q, capsule, length, low))
        return low;
    if (!isInBox(q, capsule, length, high))
        return high;
    while (high - low > 1) {
        const std::int64_t middle = (low + high) / 2;
        (isInBox(q, capsule, length, middle) ? high : low) = middle;
    }
    return high;
}

bool bears(std::uint32_t word, std::uint32_t label)
{
    return (seedWord::isMember(word) || seedWord::isPendingSeed(word))
        && seedWord::label(word) == label;
}

bool bearsAnother(std::uint32_t word, std::uint32_t label)
{
    return (seedWord::isMember(word) || seedWord::isPendingSeed(word))
        && seedWord::label(word) != label;
}

} // namespace

Capsules::Capsules(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, core::PaintLabel paint)
    : m_codes(codes)
    , m_fields(fields)
    , m_edit(paint)
    , m_frame(paint.frame)
{
}

Capsules::Capsules(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, core::PaintBarrier command)
    : m_codes(codes)
    , m_fields(fields)
    , m_edit(command)
    , m_frame(command.frame)
{
}

Capsules::Capsules(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, core::CapsuleCut cut)
    : m_codes(codes)
    , m_fields(fields)
    , m_edit(cut)
    , m_frame(cut.frame)
{
}

Position Capsules::position(const glm::ivec3& voxel) const
{
    const core::BrickGrid grid{m_codes.size};
    const glm::ivec3 o = grid.boxOf(grid.brickOf(voxel)).minimum;
    const glm::ivec3 local = voxel - o;
    Position p{};
    for (std::size_t c = 0; c < 3; ++c) {
        p[c] = round14(m_frame.origin[c] + o.x * m_frame.perI[c] + o.y * m_frame.perJ[c]
                   + o.z * m_frame.perK[c])
            + local.x * round14(m_frame.perI[c]) + local.y * round14(m_frame.perJ[c])
            + local.z * round14(m_frame.perK[c]);
    }
    return p;
}

std::optional<std::int64_t> Capsules::distance(
    const core::Capsule& capsule, Position position) const
{
    if (m_frame.isFlat) {
        if (std::abs(position[2]) > m_frame.halfThickness)
            return std::nullopt;
        position[2] = capsule.from.z;
    }
    Position q{};
    std::int64_t along = 0;
    for (int c = 0; c < 3; ++c) {
        const std::int64_t a = position[std::size_t(c)] - capsule.from[c];
        if (std::abs(a) > m_frame.reach)
            return std::nullopt;
        q[std::size_t(c)] = a >> m_frame.shift;
        along += q[std::size_t(c)] * capsule.direction[c];
    }
    if (m_frame.isSquare) {
        // Beyond the ramp it does not matter how far.
        const std::int64_t radius = std::max<std::int64_t>(m_frame.radius - capsule.less, 0);
        const std::int64_t low = (radius - m_frame.rampHalfWidth) >> m_frame.shift;
        const std::int64_t high = (radius + m_frame.rampHalfWidth) >> m_frame.shift;
        const std::int64_t half = leastBox(
            q, capsule, capsule.length >> m_frame.shift, std::max<std::int64_t>(low, 0), high + 1);
        return half * half;
    }
    const std::int64_t h =
        std::clamp<std::int64_t>(round14(along), 0, capsule.length >> m_frame.shift);
    std::int64_t squared = 0;
    for (int c = 0; c < 3; ++c) {
        const std::int64_t e = q[std::size_t(c)] - round14(h * capsule.direction[c]);
        squared += e * e;
    }
    return squared;
}

void Capsules::extend(const core::CapsulePath& path)
{
    const auto* edgewise = std::get_if<core::PaintLabel>(&m_edit);
    if (edgewise && edgewise->edges)
        return followEdges(*edgewise, path);
    const std::vector<core::Capsule>& capsules = path.capsules;
    const glm::ivec3 size = m_codes.size;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const Position at = position(voxel);
                for (const core::Capsule& capsule : capsules) {
                    const std::optional<std::int64_t> squared = distance(capsule, at);
                    if (!squared)
                        continue;
                    const std::int64_t radius =
                        std::max<std::int64_t>(m_frame.radius - capsule.less, 0);
                    const std::int64_t unitRadius = radius >> m_frame.shift;
                    if (const auto* carve = std::get_if<core::CapsuleCut>(&m_edit))
                        cut(*carve, voxel, *squared, radius);
                    else if (*squared > unitRadius * unitRadius)
                        continue;
                    else if (const auto* barrier = std::get_if<core::PaintBarrier>(&m_edit))
                        setBarrier(*barrier, voxel);
                    else
                        paint(std::get<core::PaintLabel>(m_edit), voxel);
                }
            }
        }
    }
}

void Capsules::cut(
    const core::CapsuleCut& cut, const glm::ivec3& voxel, std::int64_t squared, std::int64_t radius)
{
    if (hidesVoxel(cut.hidden, voxel))
        return;
    if (!cut.restore && cut.protectedLabels.labels.any()
        && ProtectedVoxels(m_fields, cut.protectedLabels).hold(voxel))
        return;
    const std::int64_t r = m_frame.rampHalfWidth;
    const std::int64_t t = radius - (squareRoot(squared) << m_frame.shift);
    const std::int64_t value = (std::clamp(t, -r, r) + r) * 255 / (2 * r);
    std::uint8_t& coverage = m_fields.coverage(cut.layer).at(voxel);
    coverage = cut.restore ? refilled(coverage, std::uint8_t(value))
                           : std::max(coverage, std::uint8_t(value));
}

void Capsules::paint(const core::PaintLabel& paint, const glm::ivec3& voxel)
{
    const int code = m_codes.at(voxel);
    if (code < paint.lowCode || code > paint.highCode
        || !isEditable(paint.editable, m_codes, m_fields, voxel))
        return;
    std::uint8_t& held = m_fields.labels(paint.plane).at(voxel);
    std::uint32_t& word = m_fields.seedWords(paint.plane).at(voxel);
    if (paint.erase) {
        if (held == paint.label)
            held = 0;
        if (bears(word, paint.label))
            word = seedWord::unvisited;
        return;
    }
    if (held != 0 && held != paint.label && !paint.overwritable.test(held))
        return;
    held = paint.label;
    if (word == seedWord::barrier)
        return;
    const bool isMemberOfIt = seedWord::isMember(word) && seedWord::label(word) == paint.label;
    if (paint.seeds && !isMemberOfIt)
        word = seedWord::member(0, paint.label, seedWord::seedDirection);
    else if (!paint.seeds && bearsAnother(word, paint.label))
        word = seedWord::unvisited;
}

void Capsules::setBarrier(const core::PaintBarrier& command, const glm::ivec3& voxel)
{
    setOrClearBarrier(m_fields, command.plane, command.erase, command.lockedLabels, voxel);
}

} // namespace reference

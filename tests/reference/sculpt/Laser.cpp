// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/sculpt/Laser.h"

#include <algorithm>
#include <array>
#include <utility>

namespace reference {

namespace {

constexpr std::int64_t whole = 16777216; // 2²⁴

std::int64_t round14(std::int64_t value)
{
    return floorDivide(value + 8192, 16384);
}

std::int64_t ramp(std::int64_t t, std::int64_t halfWidth)
{
    return (std::clamp(t, -halfWidth, halfWidth) + halfWidth) * 255 / (2 * halfWidth);
}

} // namespace

Laser::Laser(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> radiation,
    DenseFields& fields, core::LaserCut cut)
    : m_codes(codes)
    , m_radiation(radiation)
    , m_coverage(fields.coverage(cut.layer))
    , m_protected(fields, cut.frame.protectedLabels)
    , m_cut(std::move(cut))
    , m_plane(codes, std::move(radiation), fields, m_cut.layer, m_cut.frame)
{
}

bool Laser::materialAt(const Index16& position) const
{
    const Tissue tissue{m_codes, m_radiation, m_cut.frame.restore, m_cut.frame.asWhole};
    return tissue.material(position, m_cut.frame.thresholdCode);
}

std::int64_t Laser::weight(std::int64_t p, std::int64_t q) const
{
    const core::OutlineRaster& mask = m_cut.mask;
    const std::int64_t x = p - mask.first.x;
    const std::int64_t y = q - mask.first.y;
    if (x < 0 || y < 0 || x >= mask.size.x || y >= mask.size.y)
        return 0;
    return mask.values[std::size_t(y * mask.size.x + x)];
}

std::optional<Laser::Beam> Laser::beamAt(std::int64_t a, std::int64_t b)
{
    const core::CutFrame& frame = m_cut.frame;
    const auto hit = m_plane.cast(a, b);
    if (!hit)
        return std::nullopt;
    const std::int64_t pitch = frame.pitch;
    Beam beam;
    beam.foot = {a * pitch + pitch / 2, b * pitch + pitch / 2, hit->zSurface};

    // Rule 2. The sixteenths are counted up to.
    const std::int64_t n = floorDivide(hit->zSurface - frame.zStart, frame.zPerSample);
    const std::int64_t rest = hit->zSurface - frame.zStart - n * frame.zPerSample;
    std::int64_t q = 0;
    while (q * frame.zPerSample < 16 * rest)
        ++q;
    Index16 foot;
    std::array<Index16, 3> lattice;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t step = round14(frame.rayPerSample[axis]);
        foot[axis] =
            round14(frame.rayOrigin[axis] + a * frame.rayPerA[axis] + b * frame.rayPerB[axis])
            + n * step + floorDivide(q * step, 16);
        const std::int64_t s = m_cut.normalStep;
        lattice[0][axis] = round14(floorDivide(frame.rayPerA[axis] * s, pitch));
        lattice[1][axis] = round14(floorDivide(frame.rayPerB[axis] * s, pitch));
        lattice[2][axis] = round14(floorDivide(frame.rayPerSample[axis] * s, frame.zPerSample));
    }

    // Rule 3.
    Vector m;
    const int reach = core::LaserCut::normalReach;
    for (int z = -reach; z <= reach; ++z) {
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                if (x * x + y * y + z * z > reach * reach)
                    continue;
                Index16 at = foot;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    at[axis] += x * lattice[0][axis] + y * lattice[1][axis] + z * lattice[2][axis];
                bool hidden = false;
                for (const core::IntegerHalfSpace& half : m_cut.frame.hidden) {
                    const auto along = [&half](const Index16& v) {
                        return half.perVoxel.x * v[0] + half.perVoxel.y * v[1]
                            + half.perVoxel.z * v[2];
                    };
                    const std::int64_t base = std::clamp<std::int64_t>(
                        floorDivide(along(foot) - half.offset * 65536, 65536), -(1 << 30), 1 << 30);
                    hidden = hidden
                        || base + x * floorDivide(along(lattice[0]), 65536)
                                + y * floorDivide(along(lattice[1]), 65536)
                                + z * floorDivide(along(lattice[2]), 65536)
                            > 0;
                }
                if (!hidden && materialAt(at))
                    m = {m.x + x, m.y + y, m.z + z};
            }
        }
    }
    m.z = std::max<std::int64_t>(m.z, 0);
    if (m.x == 0 && m.y == 0 && m.z == 0)
        m.z = 1;

    // Rules 4 and 5.
    const std::int64_t length = squareRoot((m.x * m.x + m.y * m.y + m.z * m.z) * 4294967296);
    const auto unit = [length](std::int64_t component) {
        return floorDivide(2 * component * 1099511627776 + length, 2 * length);
    };
    beam.normal = {unit(m.x), unit(m.y), unit(m.z)};
    const std::int64_t c = whole + beam.normal.z;
    const std::int64_t twist = -floorDivide(beam.normal.x * beam.normal.y, c);
    beam.across = {whole - floorDivide(beam.normal.x * beam.normal.x, c), twist, -beam.normal.x};
    beam.up = {twist, whole - floorDivide(beam.normal.y * beam.normal.y, c), -beam.normal.y};

    // Rule 7.
    if (frame.throughGaps && !m_cut.restore)
        return beam;
    Index16 step;
    for (std::size_t axis = 0; axis < 3; ++axis)
        step[axis] = round14(
            floorDivide(beam.normal.x * floorDivide(frame.rayPerA[axis] * frame.zPerSample, pitch)
                    + beam.normal.y * floorDivide(frame.rayPerB[axis] * frame.zPerSample, pitch)
                    + beam.normal.z * frame.rayPerSample[axis],
                whole));
    if (m_cut.restore) {
        const Tissue tissue{m_codes, m_radiation, true};
        std::int64_t end = 0;
        for (std::int64_t i = 0; i < frame.sampleCount; ++i) {
            Index16 at = foot;
            for (std::size_t axis = 0; axis < 3; ++axis)
                at[axis] += i * step[axis];
            if (!tissue.inside(at) || !tissue.dense(at, frame.thresholdCode)
                || hidesPosition(frame.hidden, at))
                continue;
            if (!tissue.carved(at))
                break;
            end = i + 1;
        }
        if (end == 0)
            return std::nullopt;
        beam.exit = end * frame.zPerSample;
        return beam;
    }
    int run = 0;
    for (std::int64_t i = 1; i * frame.zPerSample <= frame.maxDepth; ++i) {
        Index16 at = foot;
        for (std::size_t axis = 0; axis < 3; ++axis)
            at[axis] += i * step[axis];
        run = materialAt(at) && !hidesPosition(frame.hidden, at) ? 0 : run + 1;
        if (run == frame.gapSamples) {
            beam.exit = (i - run + 1) * frame.zPerSample;
            break;
        }
    }
    return beam;
}

std::int64_t Laser::depthOf(const ElementPlane::Place& place) const
{
    if (m_cut.mode == core::DrillMode::Limit) {
        const std::vector<std::int64_t>& depths = m_depths.at(place);
        return *std::max_element(depths.begin(), depths.end());
    }
    std::int64_t dose = 0;
    for (const auto& [other, depths] : m_depths) {
        for (const std::int64_t depth : depths)
            dose += depth * weight(place.first - other.first, place.second - other.second);
    }
    return std::min<std::int64_t>(m_cut.frame.maxDepth, dose >> 16);
}

void Laser::extend(const std::vector<core::DrillSample>& samples)
{
    for (const core::DrillSample& sample : samples) {
        if (sample.depth <= 0)
            continue;
        const ElementPlane::Place place(
            floorDivide(sample.x, m_cut.frame.pitch), floorDivide(sample.y, m_cut.frame.pitch));
        m_depths[place].push_back(sample.depth);
        if (m_beams.count(place) == 0)
            m_beams[place] = beamAt(place.first, place.second);
    }
    for (const auto& [place, beam] : m_beams) {
        if (beam)
            lay(*beam, depthOf(place));
    }
}

void Laser::lay(const Beam& beam, std::int64_t depth)
{
    const core::CutFrame& frame = m_cut.frame;
    const core::BrickGrid grid{m_codes.size};
    const std::array<Vector, 3> axes{beam.across, beam.up, beam.normal};
    const auto turned = [&axes](std::size_t axis, const core::Fixed3& v) {
        return axes[axis].x * v[0] + axes[axis].y * v[1] + axes[axis].z * v[2];
    };
    const core::Fixed3 apart{floorDivide(frame.planeOrigin[0] - beam.foot.x * 16384, 64),
        floorDivide(frame.planeOrigin[1] - beam.foot.y * 16384, 64),
        floorDivide(frame.planeOrigin[2] - beam.foot.z * 16384, 64)};
    std::array<std::array<std::int64_t, 4>, 3> to; // origin, I, J, K by axis
    for (std::size_t axis = 0; axis < 3; ++axis) {
        to[axis] = {turned(axis, apart) >> 18, turned(axis, frame.planePerI) >> 24,
            turned(axis, frame.planePerJ) >> 24, turned(axis, frame.planePerK) >> 24};
        if (axis < 2)
            to[axis][0] += std::int64_t(frame.pitch / 2) * 16384;
    }
    const std::int64_t r = frame.rampHalfWidth;
    for (int z = 0; z < m_codes.size.z; ++z) {
        for (int y = 0; y < m_codes.size.y; ++y) {
            for (int x = 0; x < m_codes.size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const glm::ivec3 o = grid.boxOf(grid.brickOf(voxel)).minimum;
                const glm::ivec3 local = voxel - o;
                std::array<std::int64_t, 3> p;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const std::array<std::int64_t, 4>& t = to[axis];
                    p[axis] = round14(t[0] + o.x * t[1] + o.y * t[2] + o.z * t[3])
                        + local.x * round14(t[1]) + local.y * round14(t[2])
                        + local.z * round14(t[3]);
                }
                const std::int64_t d =
                    (depth * weight(floorDivide(p[0], frame.pitch), floorDivide(p[1], frame.pitch)))
                    >> 8;
                if (d <= 0 || hidesVoxel(frame.hidden, voxel))
                    continue;
                if (m_cut.laying == core::Laying::Carve && m_protected.hold(voxel))
                    continue;
                const std::int64_t from = beam.exit - depth < frame.front ? 0 : beam.exit - depth;
                const auto cut = std::uint8_t(m_cut.restore
                        ? std::min(ramp(from + d + floorDivide(frame.front, 2) + r - p[2], r),
                            ramp(p[2] - from + (from == 0 ? m_cut.lift : 0), r))
                        : std::min(
                            ramp(std::min(d, beam.exit) - p[2], r), ramp(p[2] + m_cut.lift, r)));
                std::uint8_t& coverage = m_coverage.at(voxel);
                coverage = m_cut.laying == core::Laying::Carve ? std::max(coverage, cut)
                                                               : refilled(coverage, cut);
            }
        }
    }
}

} // namespace reference

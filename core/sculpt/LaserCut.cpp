// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/LaserCut.h"

#include <algorithm>

namespace core {

using fixedPoint::round14;

namespace {

constexpr std::int64_t one24 = std::int64_t(1) << 24;

std::int64_t divided(std::int64_t value, std::int64_t divisor)
{
    const std::int64_t quotient = value / divisor;
    return quotient * divisor > value ? quotient - 1 : quotient;
}

/// v · factor / divisor per component.
Fixed3 scaled(const Fixed3& v, std::int64_t factor, std::int64_t divisor)
{
    return {divided(v[0] * factor, divisor), divided(v[1] * factor, divisor),
        divided(v[2] * factor, divisor)};
}

std::int64_t dotFixed(const Fixed3& a, const Fixed3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

std::int32_t restoredFrom(const LaserCut& cut, std::int32_t end, std::int32_t depth)
{
    const std::int32_t from = end - depth;
    return from < cut.frame.front ? 0 : from;
}

glm::ivec3 footPosition(const CutFrame& frame, const glm::ivec2& element, std::int32_t surface)
{
    const std::int64_t t = std::int64_t(surface) - frame.zStart;
    const std::int64_t n = divided(t, frame.zPerSample);
    const std::int64_t q =
        divided(16 * (t - n * frame.zPerSample) + frame.zPerSample - 1, frame.zPerSample);
    glm::ivec3 position;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = std::size_t(axis);
        const std::int64_t start = round14(
            frame.rayOrigin[i] + element.x * frame.rayPerA[i] + element.y * frame.rayPerB[i]);
        const std::int64_t step = round14(frame.rayPerSample[i]);
        position[axis] = int(start + n * step + ((q * step) >> 4));
    }
    return position;
}

LaserLattice laserLattice(const LaserCut& cut)
{
    const CutFrame& frame = cut.frame;
    return {round14(scaled(frame.rayPerA, cut.normalStep, frame.pitch)),
        round14(scaled(frame.rayPerB, cut.normalStep, frame.pitch)),
        round14(scaled(frame.rayPerSample, cut.normalStep, frame.zPerSample))};
}

LaserBeam laserBeam(const CutFrame& frame, const glm::ivec2& element, std::int32_t surface,
    const glm::ivec3& gradient)
{
    glm::ivec3 m(gradient.x, gradient.y, std::max(gradient.z, 0));
    if (m == glm::ivec3(0))
        m.z = 1;
    const std::int64_t squared = dotFixed({m.x, m.y, m.z}, {m.x, m.y, m.z});
    const std::int64_t length = fixedPoint::squareRoot(squared << 32);
    Fixed3 n;
    for (int axis = 0; axis < 3; ++axis)
        n[std::size_t(axis)] = divided(2 * (m[axis] * (one24 << 16)) + length, 2 * length);
    const std::int64_t c = one24 + n[2];
    const std::int64_t twist = -divided(n[0] * n[1], c);
    const std::array<Fixed3, 3> axes{Fixed3{one24 - divided(n[0] * n[0], c), twist, -n[0]},
        Fixed3{twist, one24 - divided(n[1] * n[1], c), -n[1]}, n};

    LaserBeam beam;
    beam.foot = {element.x * frame.pitch + frame.pitch / 2,
        element.y * frame.pitch + frame.pitch / 2, surface};
    beam.normal = {int(n[0]), int(n[1]), int(n[2])};
    Fixed3 apart;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = std::size_t(axis);
        apart[i] = (frame.planeOrigin[i] - std::int64_t(beam.foot[axis]) * 16384) >> 6;
    }
    const std::int64_t halfElement = std::int64_t(frame.pitch / 2) * 16384;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        beam.perI[axis] = dotFixed(axes[axis], frame.planePerI) >> 24;
        beam.perJ[axis] = dotFixed(axes[axis], frame.planePerJ) >> 24;
        beam.perK[axis] = dotFixed(axes[axis], frame.planePerK) >> 24;
        beam.origin[axis] = (dotFixed(axes[axis], apart) >> 18) + (axis < 2 ? halfElement : 0);
    }
    return beam;
}

glm::ivec4 hiddenAround(
    const IntegerHalfSpace& half, const glm::ivec3& foot, const LaserLattice& lattice)
{
    constexpr std::int64_t far = std::int64_t(1) << 30;
    const auto along = [&half](const glm::ivec3& v) {
        return dotFixed({half.perVoxel.x, half.perVoxel.y, half.perVoxel.z}, {v.x, v.y, v.z});
    };
    return {int(std::clamp((along(foot) - half.offset * 65536) >> 16, -far, far)),
        int(along(lattice.u) >> 16), int(along(lattice.v) >> 16), int(along(lattice.w) >> 16)};
}

glm::ivec3 beamBase(const LaserBeam& beam, const glm::ivec3& firstVoxel)
{
    glm::ivec3 base;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = std::size_t(axis);
        base[axis] = int(round14(beam.origin[i] + firstVoxel.x * beam.perI[i]
            + firstVoxel.y * beam.perJ[i] + firstVoxel.z * beam.perK[i]));
    }
    return base;
}

bool isSound(const LaserCut& cut)
{
    if (cut.normalStep < 1 || cut.lift < 0 || cut.frame.pitch < 1 || cut.frame.zPerSample < 1)
        return false;
    const LaserLattice lattice = laserLattice(cut);
    for (const glm::ivec3& step : {lattice.u, lattice.v, lattice.w}) {
        const glm::ivec3 size = glm::abs(step);
        if (std::max({size.x, size.y, size.z}) > 1 << 20)
            return false;
    }
    return true;
}

glm::ivec3 beamStep(const CutFrame& frame, const LaserBeam& beam)
{
    const Fixed3 a = scaled(frame.rayPerA, frame.zPerSample, frame.pitch);
    const Fixed3 b = scaled(frame.rayPerB, frame.zPerSample, frame.pitch);
    Fixed3 step;
    for (std::size_t axis = 0; axis < 3; ++axis)
        step[axis] = (beam.normal.x * a[axis] + beam.normal.y * b[axis]
                         + beam.normal.z * frame.rayPerSample[axis])
            >> 24;
    return round14(step);
}

Result<void> checkSound(const LaserCut& cut, const BrickGrid&)
{
    if (const Result<void> checked = checkSound(cut.frame); !checked)
        return checked;
    if (!isSound(cut))
        return failure(
            ErrorCode::InvalidField, QStringLiteral("laser"), Clause::saying("is not sound"));
    return {};
}

} // namespace core

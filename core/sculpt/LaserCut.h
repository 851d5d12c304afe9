// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/DrillCut.h"
#include "core/sculpt/MaskFrame.h"
#include "core/sculpt/MaskRaster.h"

#include <cstdint>

namespace core {

/// A laser stroke in integers (seed A §4.3): where one ray under the mask's middle meets the
/// surface, the mask stands across the surface's gradient and goes in along it. It begins with the
/// plane of MaskFrame.h, whose rules 2 to 6 it goes on with. All divisions are by positive numbers
/// and round down; >> likewise.
///
/// 1. Beams. A sample s with depth_s > 0 lies in the element (a, b) = (x_s / pitch, y_s / pitch).
///    An element that samples lie in and that meets a surface (MaskFrame.h, rules 2 to 4) has a
///    beam. With m(p, q) the value of `mask` at (p, q), 0 … 256, its depth D is, in mode Limit, the
///    greatest depth_s of the samples that lie in it, and in mode Rate
///    min(maxDepth, (Σ over all samples s of depth_s · m(a − a_s, b − b_s)) >> 16), 64-bit. So it
///    matters neither in which order samples come nor how many of them there are.
/// 2. Foot. F = (a·pitch + pitch/2, b·pitch + pitch/2, zSurface) in plane coordinates. With
///    t = zSurface − zStart, n = t / zPerSample, q = (16·(t − n·zPerSample) + zPerSample − 1) /
///    zPerSample: P = P(n, q) of MaskFrame.h's rule 2 for that element.
/// 3. Gradient. With s = normalStep: U = round14(rayPerA·s / pitch),
///    V = round14(rayPerB·s / pitch),
///    W = round14(rayPerSample·s / zPerSample). M = Σ o over all o in ℤ³ with |o|² ≤ normalReach²
///    for which there is material (rule 3) at p = P + o.x·U + o.y·V + o.z·W that is not
///    hidden (hiddenAround()): it points into the material. M.z = max(M.z, 0); M = (0, 0, 1) where
///    it is 0.
/// 4. Normal. L = ⌊√((M·M) << 32)⌋; N = ((2·(M << 40) + L) / (2·L)) per component: about
///    2²⁴ · M / |M|.
/// 5. Across. The least turn that takes the view's axes along: with c = 2²⁴ + N.z,
///    X = (2²⁴ − N.x² / c, −(N.x·N.y / c), −N.x), Y = (−(N.x·N.y / c), 2²⁴ − N.y² / c, −N.y).
/// 6. Beam coordinates. For e = X, Y, N (per component of the result) and v = planePerI, …:
///    perI = (e · planePerI) >> 24, likewise J and K;
///    origin = (e · ((planeOrigin − F·2¹⁴) >> 6)) >> 18; then pitch/2 · 2¹⁴ is added to origin's x
///    and y. Rule 6 of MaskFrame.h makes of these the coordinates (x, y, z) of voxels.
/// 7. Gap. S = round14((N.x·(rayPerA·zPerSample / pitch) + N.y·(rayPerB·zPerSample / pitch)
///    + N.z·rayPerSample) >> 24). For n = 1, 2, … while n·zPerSample ≤ maxDepth: the first run of
///    gapSamples consecutive positions P + n·S that are hidden or without material ends the beam at
///    E = (first of the run)·zPerSample. No such run, or throughGaps: E = 2³¹ − 1.
///    Restoring, a beam is found as though nothing were carved (the frame is `asWhole`), and goes
///    as far as something is: of P + n·S, n = 0, 1, 2, … while n < sampleCount, that is dense and
///    not hidden, by the rule 3 of restoring, the first that is not carved is passed by none; with
///    n_c the last carved one before it, E = (n_c + 1)·zPerSample. None: the beam does nothing.
/// 8. Voxels. With d = (D · m(x / pitch, y / pitch)) >> 8: where d > 0,
///    cut = min(ramp(min(d, E) − z), ramp(z + lift)). Restoring, T = E − D, but 0 where that is
///    < front: min(ramp(T + d + front/2 + r − z), ramp(z − T)), and ramp(z + lift) for the latter
///    where T = 0. It is laid as rule 6 of MaskFrame.h says; of several beams
///    the greatest.
struct LaserCut {
    static constexpr int normalReach = 7;

    std::uint8_t layer = 0;
    MaskFrame frame;
    MaskRaster mask{}; ///< its origin is the middle of element (0, 0)
    DrillMode mode = DrillMode::Limit;
    std::int32_t normalStep = 1; ///< mm16, ≥ 1
    std::int32_t lift = 0; ///< mm16, ≥ 0: the mask begins so far above the foot
    bool restore = false; ///< backwards: rules 7 and 8; the frame's own `restore` is off
    Laying laying = Laying::Carve;
};

/// Rule 8: T. @param end E
[[nodiscard]] std::int32_t restoredFrom(const LaserCut& cut, std::int32_t end, std::int32_t depth);

/// Where a beam begins and which way it goes.
struct LaserBeam {
    glm::ivec3 foot{0}; ///< F, mm16
    glm::ivec3 normal{0}; ///< N, 2⁻²⁴
    Fixed3 origin{}; ///< rule 6: beam coordinates of voxel (0, 0, 0), mm · 2³⁰
    Fixed3 perI{};
    Fixed3 perJ{};
    Fixed3 perK{};
};

/// Rule 2: P. @param surface zSurface
[[nodiscard]] glm::ivec3 footPosition(
    const MaskFrame& frame, const glm::ivec2& element, std::int32_t surface);

/// Rule 3: U, V, W, as matrix columns.
struct LaserLattice {
    glm::ivec3 u{0};
    glm::ivec3 v{0};
    glm::ivec3 w{0};
};
[[nodiscard]] LaserLattice laserLattice(const LaserCut& cut);

/// Rule 3: whether P + o is hidden by a half: where the sum of `x` and o · (y, z, w) is above 0.
/// That is (perVoxel · P − offset · 2¹⁶) >> 16, no farther than ±2³⁰, and (perVoxel · U) >> 16, ….
[[nodiscard]] glm::ivec4 hiddenAround(
    const HiddenHalf& half, const glm::ivec3& foot, const LaserLattice& lattice);

/// Rules 2 and 4 to 6. @param gradient Σ o of rule 3
[[nodiscard]] LaserBeam laserBeam(const MaskFrame& frame, const glm::ivec2& element,
    std::int32_t surface, const glm::ivec3& gradient);

/// Rule 6: beam coordinates of a brick's first voxel, mm16.
[[nodiscard]] glm::ivec3 beamBase(const LaserBeam& beam, const glm::ivec3& firstVoxel);

/// Whether every number is one that the rules allow.
[[nodiscard]] bool isSound(const LaserCut& cut);

/// Rule 7: S.
[[nodiscard]] glm::ivec3 beamStep(const MaskFrame& frame, const LaserBeam& beam);

[[nodiscard]] Result<void> checkSound(const LaserCut& cut, const BrickGrid& grid);

} // namespace core

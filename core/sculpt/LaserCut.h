// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CutFrame.h"
#include "core/sculpt/DrillCut.h"
#include "core/sculpt/OutlineRaster.h"

#include <cstdint>

namespace core {

/// A laser stroke in integers (seed A §4.3): where one ray under the middle of the mask meets the
/// surface, the mask is placed perpendicular to the surface's gradient and moved inwards along it.
/// It begins on the plane of CutFrame.h and continues with rules 2 to 6 of that header. All
/// divisions are by positive numbers and round down; so does >>.
///
/// 1. Beams. A sample s with depth_s > 0 lies in the element (a, b) = (x_s / pitch, y_s / pitch).
///    An element in which samples lie and that meets a surface (CutFrame.h, rules 2 to 4) has a
///    beam. Let m(p, q) be the value of `mask` at (p, q), 0 … 256. The depth D of the beam is, in
///    mode Limit, the greatest depth_s of the samples in it, and in mode Rate
///    min(maxDepth, (Σ over all samples s of depth_s · m(a − a_s, b − b_s)) >> 16), in 64 bits. So
///    neither the order of the samples nor their number matters.
/// 2. Foot. F = (a·pitch + pitch/2, b·pitch + pitch/2, zSurface) in plane coordinates. With
///    t = zSurface − zStart, n = t / zPerSample and q = (16·(t − n·zPerSample) + zPerSample − 1) /
///    zPerSample, P is P(n, q) of CutFrame.h, rule 2, for that element.
/// 3. Gradient. With s = normalStep: U = round14(rayPerA·s / pitch),
///    V = round14(rayPerB·s / pitch), W = round14(rayPerSample·s / zPerSample). M = Σ o over all o
///    in ℤ³ with |o|² ≤ normalReach² for which p = P + o.x·U + o.y·V + o.z·W is material (rule 3
///    of CutFrame.h) and not hidden (hiddenAround()); it points into the material. Then
///    M.z = max(M.z, 0), and M = (0, 0, 1) if M is 0.
/// 4. Normal. L = ⌊√((M·M) << 32)⌋; N = ((2·(M << 40) + L) / (2·L)) per component, which is about
///    2²⁴ · M / |M|.
/// 5. Axes across the beam, by the smallest rotation of the view's axes: with c = 2²⁴ + N.z,
///    X = (2²⁴ − N.x² / c, −(N.x·N.y / c), −N.x), Y = (−(N.x·N.y / c), 2²⁴ − N.y² / c, −N.y).
/// 6. Beam coordinates. For e = X, Y, N (the components of the result):
///    perI = (e · planePerI) >> 24, and perJ, perK likewise;
///    origin = (e · ((planeOrigin − F·2¹⁴) >> 6)) >> 18; then pitch/2 · 2¹⁴ is added to x and y of
///    origin. Rule 6 of CutFrame.h derives the coordinates (x, y, z) of voxels from these.
/// 7. End of the beam. S = round14((N.x·(rayPerA·zPerSample / pitch) + N.y·(rayPerB·zPerSample /
///    pitch) + N.z·rayPerSample) >> 24).
///    Carving: for n = 1, 2, … while n·zPerSample ≤ maxDepth, the first run of gapSamples
///    consecutive positions P + n·S that are hidden or not material ends the beam at
///    E = (first n of the run)·zPerSample. Without such a run, or with throughGaps, E = 2³¹ − 1.
///    Restoring: the beam is found as if nothing were carved (the frame is `asWhole`). Of the
///    positions P + n·S, n = 0, 1, 2, … while n < sampleCount, those count that are inside, dense
///    and not hidden, by CutFrame.h's rule 3 for restoring. The first of these that is not carved
///    ends the search; n_c is the last carved one before it, and E = (n_c + 1)·zPerSample. If there
///    is none, the beam does nothing.
/// 8. Voxels. Let d = (D · m(x / pitch, y / pitch)) >> 8. Where d > 0:
///    Carving: cut = min(ramp(min(d, E) − z), ramp(z + lift)).
///    Restoring: T = E − D, or 0 if that is < front; cut = min(ramp(T + d + front/2 + r − z),
///    ramp(z − T)), where the latter is ramp(z + lift) if T = 0.
///    The cut is applied as CutFrame.h, rule 6, says; of several beams the greatest counts.
struct LaserCut {
    static constexpr int normalReach = 7;

    std::uint8_t layer = 0;
    CutFrame frame;
    OutlineRaster mask{}; ///< its origin is the middle of element (0, 0)
    DrillMode mode = DrillMode::Limit;
    std::int32_t normalStep = 1; ///< mm16, ≥ 1
    std::int32_t lift = 0; ///< mm16, ≥ 0: how far above the foot the mask begins
    /// refill instead of carve: rules 7 and 8; the frame's own `restore` is off
    bool restore = false;
    Laying laying = Laying::Carve;
};

/// T of rule 8. @param end E
[[nodiscard]] std::int32_t restoredFrom(const LaserCut& cut, std::int32_t end, std::int32_t depth);

/// Where a beam begins, its direction, and the coordinates of voxels along it.
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
    const CutFrame& frame, const glm::ivec2& element, std::int32_t surface);

/// Rule 3: U, V, W, as matrix columns.
struct LaserLattice {
    glm::ivec3 u{0};
    glm::ivec3 v{0};
    glm::ivec3 w{0};
};
[[nodiscard]] LaserLattice laserLattice(const LaserCut& cut);

/// Rule 3: P + o is hidden by a half-space if the sum of `x` and o · (y, z, w) is above 0. These
/// are (perVoxel · P − offset · 2¹⁶) >> 16, clamped to ±2³⁰, and (perVoxel · U) >> 16 and so on.
[[nodiscard]] glm::ivec4 hiddenAround(
    const IntegerHalfSpace& half, const glm::ivec3& foot, const LaserLattice& lattice);

/// Rules 2 and 4 to 6. @param gradient Σ o of rule 3
[[nodiscard]] LaserBeam laserBeam(const CutFrame& frame, const glm::ivec2& element,
    std::int32_t surface, const glm::ivec3& gradient);

/// Rule 6: beam coordinates of a brick's first voxel, mm16.
[[nodiscard]] glm::ivec3 beamBase(const LaserBeam& beam, const glm::ivec3& firstVoxel);

/// Whether every number is in the range that the rules allow.
[[nodiscard]] bool isSound(const LaserCut& cut);

/// Rule 7: S.
[[nodiscard]] glm::ivec3 beamStep(const CutFrame& frame, const LaserBeam& beam);

[[nodiscard]] Result<void> checkSound(const LaserCut& cut, const BrickGrid& grid);

} // namespace core

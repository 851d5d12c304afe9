// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// Three 64-bit fixed-point coordinates.
using Fixed3 = std::array<std::int64_t, 3>;

/// A drill stroke in integers: everything that decides a voxel (seed A §4.1, 4.2; DESIGN §5, mode
/// Limit). Both engines follow the rules below to the bit.
///
/// Spaces. *Plane* coordinates (x right, y up, z along the view direction) are mm from the view's
/// target, in 16.16 fixed point ("mm16") unless 2⁻³⁰ is said. *Index* coordinates are voxels, 16.16
/// ("index16") unless 2⁻³⁰ is said. `>>` is the arithmetic shift (rounds down); round14(v) is
/// (v + 2¹³) >> 14 and brings 2⁻³⁰ to 2⁻¹⁶.
///
/// 1. Elements. The mask plane is a raster of square elements; element (a, b) covers
///    [a·pitch, (a+1)·pitch) × [b·pitch, (b+1)·pitch), centre c = (a·pitch + pitch/2, …) (integer
///    division). Its depth is D(a, b) = max over samples s of (depth_s · m) >> 8 with
///    m = clamp(⌊((maskRadius − d)·256 + 128·pitch) / pitch⌋, 0, 256), d = ⌊√(dx² + dy²)⌋, dx, dy
///    from the sample to c. 64-bit.
/// 2. Rays. Every element with D > 0 is cast once. P₀ = round14(rayOrigin + a·rayPerA + b·rayPerB),
///    S = round14(rayPerSample), per component; where P₀ leaves ±2³⁰ the element cuts nothing (it
///    lies far from the volume). The position at sample n plus q sixteenths is
///    P(n, q) = P₀ + n·S + ((q·S) >> 4), its height z(n, q) = zStart + n·zPerSample +
///    ((q·zPerSample) >> 4).
/// 3. Material at P (index16). Outside unless 0 ≤ P ≤ (size − 1)·2¹⁶ in every component. i = P >>
/// 16,
///    f = (P & 0xFFFF) >> 8, neighbours clamped to size − 1. Codes are interpolated along x, y, z:
///    X = (c₀(256−f) + c₁f) >> 4, Y = (X₀(256−f) + X₁f) >> 4, Z = Y₀(256−f) + Y₁f, all in unsigned
///    32 bits; dense iff Z ≥ thresholdCode·2¹⁶ (thresholdCode 65536: never dense). Radiation (see
///    Radiation.h) *as it was when the stroke began* is interpolated alike without the shifts;
///    carved iff the result ≥ 128·2²⁴. Material = inside, dense and not carved.
/// 4. Surface. n₀ = the first sample 0 ≤ n < sampleCount with material at (n, 0); none: the element
///    cuts nothing. For n₀ > 0 four bisections of [(n₀−1)·16, n₀·16] in sixteenths (middle =
///    (low + high) / 2; material → high, else low) give (n, q) = (high / 16, high % 16);
///    for n₀ = 0 it is (0, 0). zSurface = z(n, q).
/// 5. Gap. From n₀ + 1 on, while n < sampleCount and z(n, 0) ≤ zSurface + maxDepth: the first run
/// of
///    gapSamples consecutive samples without material (at (n, 0)) ends the cut at z(first of the
///    run, 0) =: zExit. A run cut short by the end of the march does not count. No such run, or
///    throughGaps: zExit = 2³¹ − 1.
/// 6. Voxels. For a brick with first voxel o: base = round14(planeOrigin + o.x·planePerI +
///    o.y·planePerJ + o.z·planePerK), and for the voxel at local (i, j, k):
///    (x, y, z) = base + i·round14(planePerI) + j·round14(planePerJ) + k·round14(planePerK).
///    a = ⌊x / pitch⌋, b = ⌊y / pitch⌋. No element, D = 0 or no surface: nothing. Otherwise
///    zEnd = min(zSurface + D, zExit), ramp(t) = ((clamp(t, −r, r) + r)·255) / (2r) with
///    r = rampHalfWidth, cut = min(ramp(zEnd − z), ramp(z − (zSurface − 2r))).
///    coverage = max(coverage, cut).
struct DrillFrame {
    Fixed3 planeOrigin{}; ///< plane coordinates of voxel (0, 0, 0), mm · 2³⁰
    Fixed3 planePerI{}; ///< change per voxel along i, mm · 2³⁰
    Fixed3 planePerJ{};
    Fixed3 planePerK{};
    Fixed3 rayOrigin{}; ///< index coordinates of the centre of element (0, 0) at zStart, · 2³⁰
    Fixed3 rayPerA{};
    Fixed3 rayPerB{};
    Fixed3 rayPerSample{};
    std::int32_t pitch = 0; ///< side of an element, mm16
    std::int32_t zStart = 0; ///< mm16; before the volume begins
    std::int32_t zPerSample = 0; ///< mm16
    std::int32_t sampleCount = 0; ///< up to behind the volume
    std::int32_t rampHalfWidth = 0; ///< mm16, half the finest spacing
    std::int32_t thresholdCode = 0; ///< the surface: codes ≥ this are seen
    std::int32_t maskRadius = 0; ///< mm16
    std::int32_t maxDepth = 0; ///< mm16, depth at full pressure
    std::int32_t gapSamples = 0; ///< ≥ 1
    bool throughGaps = false;
};

/// One point of the resampled path: where the mask stood and how deep it was pressed.
struct DrillSample {
    std::int32_t x = 0; ///< mm16
    std::int32_t y = 0; ///< mm16
    std::int32_t depth = 0; ///< mm16, 0 … maxDepth
};

/// A stretch of mask elements, both ends included.
struct ElementBox {
    glm::ivec2 minimum{0};
    glm::ivec2 maximum{-1};
};

/// Rule 1: the depth of one element under one sample.
[[nodiscard]] std::int32_t elementDepth(
    const DrillFrame& frame, const DrillSample& sample, const glm::ivec2& element);

/// Elements that a sample can reach.
[[nodiscard]] ElementBox elementsUnder(const DrillFrame& frame, const DrillSample& sample);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

struct MillimetreBall;
struct VolumeGeometry;

/// The voxels around one that count for smoothness, with their weights; a step and the opposite one
/// weigh the same.
struct ContourKernel {
    struct Step {
        glm::ivec3 to{0}; ///< never 0
        int weight = 0; ///< 1 … 256
    };
    std::vector<Step> steps{};
    glm::ivec3 extent{0}; ///< no step is longer along an axis
    int total = 0; ///< of all weights
};

/// w(d) = min(⌊(R² − |d|²) / max(⌊R² / 256⌋, 1)⌋, 256) of each step d ≠ 0 for which that is at
/// least 1, with the squares that a MillimetreBall of the radius R has. R is 2.5 times the finest
/// spacing; on anisotropic grids 1.25 times the coarsest one where that is more, but at most 4
/// times the finest.
[[nodiscard]] ContourKernel contourKernel(const VolumeGeometry& geometry);
[[nodiscard]] ContourKernel contourKernel(const MillimetreBall& ball);

/// How the contour of a segment evolves, generation by generation, in whole numbers.
///
/// x(v) is 1 where the voxel v belongs to the segment and −1 elsewhere, also where it belongs to
/// another one; W = kernel.total. A voxel may change if it is free, the segment's own, or another
/// segment's that may be overwritten. Where a rule reads the code of a voxel outside the volume,
/// the nearest one inside is read instead.
///
/// 1. Region. With d = 2 · min(code(v) − lowCode, highCode − code(v)) + 1
///      r(v) = clamp(256 · d / (2 · softness + 1), −256, 256), rounded towards 0:
///    positive within the interval, negative beyond it, and the full 256 as many codes from its
///    ends as `softness` says.
/// 2. Edges. With ta = min(⌊gradientWeights[a] · |code(v + ea) − code(v − ea)| / 1024⌋, 32767)
/// along
///    each axis a, as growth has it, m = tx² + ty² + tz² and k = halfGradient²,
///      h(v) = 1 + ⌊254 · k / (k + m)⌋,   g(v) = 255 − ⌊edge · (255 − h(v)) / 100⌋:
///    255 where the image is even, less the steeper it is.
/// 3. Smoothness. With the sum over the kernel's steps d that stay within the volume
///      a(v) = Σ w(d) · (g(v) + g(v + d)) · x(v + d).
/// 4. The speed of v is F(v) = region · W · r(v) + smoothness · a(v). v wants to belong to the
///    segment if F(v) > 0, not to belong to it if F(v) < 0, and stays as it is if F(v) = 0.
/// 5. v is at the front if it may change and one of its neighbours in the volume is on the other
///    side: of the six that share a face with it; in a wide generation, of the eighteen that share
///    a face or an edge. Wide are, with `round`, the generations of even number, counted from 1,
///    and those that would change nothing otherwise.
/// 6. A generation asks those voxels that are at the front when it begins, class by class. The
/// class
///    of (x, y, z) is (x mod p.x) + p.x · ((y mod p.y) + p.y · (z mod p.z)), with the periods
///    p = max(kernel.extent, 1) + 1, and classes come in ascending order. All voxels of a class are
///    asked before any of them changes: those that are still at the front and want the other side
///    go there.
/// 7. The contour rests when a generation changes nothing.
///
/// No two voxels of a class see each other, so neither order nor threads matter, and each change by
/// itself lowers
///      E = −region · W · Σ r(v) x(v) − smoothness · Σ w(d) (g(v) + g(v + d)) x(v) x(v + d)
/// (the second sum over pairs of voxels): the contour never oscillates, and it always comes to
/// rest. A voxel's speed depends on the labels alone, so evolving by 4 generations and then by 6 is
/// evolving by 10; with `round`, the first part must be of an even number of generations for that.
///
/// Where nothing holds it, a contour grows to an octahedron, which has a third of the volume of the
/// ball of its width. By turns of six and eighteen neighbours it becomes a body of 14 faces, which
/// has the ball's volume within some per cent. Both are counted in voxels, not in millimetres.
///
/// On grids with thick slices a new slice has few neighbours that count, so from a smoothness of
/// about 60 on, with a region of 100, the contour hardly crosses slices of 3 mm with pixels of 1
/// mm.
///
/// E is the length of the contour, measured shorter along edges, in the cut metric of Boykov and
/// Kolmogorov (2003): that of geodesic active contours (Caselles, Kimmel and Sapiro 1997), which an
/// edge attracts because g falls towards it. To it comes the competition of two regions (Zhu and
/// Yuille 1996), where a soft interval of values stands for the logarithm of the likelihoods, as in
/// ITK-SNAP. What those do with a level set and real numbers, voxels do here one by one.
struct ContourRule {
    int lowCode = 0; ///< may lie beyond all codes, which then have no end on this side
    int highCode = 65535;
    int softness = 0; ///< codes
    int region = 100; ///< 0 … 100, as the next two
    int edge = 0; ///< 0: edges count for nothing
    int smoothness = 50;
    glm::ivec3 gradientWeights{0}; ///< GrowLimits
    int halfGradient = 1; ///< the magnitude at which an edge counts half, 1 … 65535
    bool round = false; ///< every second generation is wide
    ContourKernel kernel{};
};

/// A bound beyond all codes, and so far from them that what lies there counts in full.
constexpr int noContourBound = 1 << 20;

/// r(v) of a voxel with this code.
[[nodiscard]] int regionSpeed(const ContourRule& rule, int code);
/// g(v) of a voxel. @param squaredMagnitude m
[[nodiscard]] int edgeWeight(const ContourRule& rule, std::uint64_t squaredMagnitude);

} // namespace core

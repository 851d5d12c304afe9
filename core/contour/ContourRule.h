// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

struct MillimetreBall;
struct VolumeGeometry;

/// The steps from a voxel to the surrounding voxels that count for smoothness, with their weights.
/// A step and the opposite one have the same weight.
struct ContourKernel {
    struct Step {
        glm::ivec3 to{0}; ///< never 0
        int weight = 0; ///< 1 … 256
    };
    std::vector<Step> steps{};
    glm::ivec3 extent{0}; ///< the longest step along each axis, in voxels
    int total = 0; ///< sum of all weights
};

/// w(d) = min(⌊(R² − |d|²) / max(⌊R² / 256⌋, 1)⌋, 256) for each step d ≠ 0 for which this is at
/// least 1; the squared lengths are those of a MillimetreBall with radius R. R is the greater of
/// 2.5 times the finest spacing and 1.25 times the coarsest one, of which the latter counts at most
/// 4 times the finest spacing.
[[nodiscard]] ContourKernel contourKernel(const VolumeGeometry& geometry);
[[nodiscard]] ContourKernel contourKernel(const MillimetreBall& ball);

/// How the contour of a segment evolves, generation by generation, in whole numbers.
///
/// x(v) is 1 where the voxel v belongs to the segment and −1 elsewhere, also where it belongs to
/// another one; W = kernel.total. A voxel may change if it is free, the segment's own, or another
/// segment's that may be overwritten; with `erase` only the segment's own. Where a rule reads the
/// code of a voxel outside the volume, the nearest one inside is read instead.
///
/// 1. Region. With d = 2 · min(code(v) − lowCode, highCode − code(v)) + 1
///      r(v) = clamp(256 · d / (2 · softness + 1), −256, 256), rounded towards 0:
///    positive within the interval, negative outside it, and the full ±256 from `softness` codes
///    away from its ends. With `erase` it has the opposite sign.
/// 2. Edges. With ta = min(⌊gradientWeights[a] · |code(v + ea) − code(v − ea)| / 1024⌋, 32767)
///    along each axis a, as in growth, m = tx² + ty² + tz² and k = halfGradient²,
///      h(v) = 1 + ⌊254 · k / (k + m)⌋,   g(v) = 255 − ⌊edge · (255 − h(v)) / 100⌋:
///    255 where the image is flat, and smaller the steeper it is.
/// 3. Smoothness. Summed over the kernel's steps d that stay within the volume and lead to no voxel
///    that is absent (ContourGround::absent),
///      a(v) = Σ w(d) · (g(v) + g(v + d)) · x(v + d).
/// 4. The speed of v is F(v) = region · W · r(v) + smoothness · a(v). v wants to belong to the
///    segment if F(v) > 0, not to belong to it if F(v) < 0, and stays as it is if F(v) = 0.
/// 5. v is at the front if it may change and one of its neighbours in the volume, which is not
///    absent, is on the other side: of the six that share a face with it; in a wide generation, of
///    the eighteen that share a face or an edge. With `round`, a generation is wide if its number,
///    counted from 1, is even, or if it would change nothing as a narrow one. Without `round` no
///    generation is wide.
/// 6. A generation examines the voxels that are at the front when it begins, class by class. The
///    class of (x, y, z) is (x mod p.x) + p.x · ((y mod p.y) + p.y · (z mod p.z)), with the periods
///    p = max(kernel.extent, 1) + 1, and classes are taken in ascending order. All voxels of a
///    class are examined before any of them changes; then those that are still at the front and
///    want to change sides do so.
/// 7. The contour is at rest when a generation changes nothing.
///
/// No two voxels of a class influence each other, so neither order nor threads matter, and each
/// single change lowers
///      E = −region · W · Σ r(v) x(v) − smoothness · Σ w(d) (g(v) + g(v + d)) x(v) x(v + d) (the
///      second sum over pairs of voxels): the contour never oscillates, and it always comes to
///      rest. A voxel's speed depends on the labels alone, so evolving by 4 generations and then by
///      6 gives the same as evolving by 10; with `round` this holds if the first part has an even
///      number of generations.
///
/// Where nothing stops it, a contour grows into an octahedron, which has a third of the volume of a
/// ball of the same width. With `round`, six and eighteen neighbours alternate, and it grows into a
/// body with 14 faces, whose volume is that of the ball to within some per cent. Both shapes are
/// regular in voxels, not in millimetres.
///
/// On grids with thick slices, few of the neighbours that count lie in another slice. So with
/// `region` 100 and a smoothness of about 60 or more, the contour hardly crosses from slice to
/// slice if slices are 3 mm and pixels 1 mm apart.
///
/// The second sum of E is the length of the contour, weighted so that it counts less along edges,
/// in the cut metric of Boykov and Kolmogorov (2003). This is the length of geodesic active
/// contours (Caselles, Kimmel and Sapiro 1997): edges attract them because g falls towards an edge.
/// The first sum is region competition (Zhu and Yuille 1996), where a soft interval of values takes
/// the place of the log likelihoods, as in ITK-SNAP. Those methods evolve a level set in real
/// numbers; here single voxels change sides.
struct ContourRule {
    int lowCode = 0; ///< may lie below all codes: then the interval is open on this side
    int highCode = 65535;
    int softness = 0; ///< over how many codes r(v) rises to its full value
    int region = 100; ///< how much values count, 0 … 100; so are the next two
    int edge = 0; ///< how much edges count; 0: not at all
    int smoothness = 50;
    glm::ivec3 gradientWeights{0}; ///< as in GrowLimits
    int halfGradient = 1; ///< the gradient magnitude at which h(v) is about half, 1 … 65535
    bool round = false; ///< every second generation is wide
    bool erase = false; ///< voxels leave the segment where values lie in the interval
    ContourKernel kernel{};
};

/// A bound so far outside all codes that r(v) is not reduced near the end of the codes;
/// −noContourBound is the lower one.
constexpr int noContourBound = 1 << 20;

/// r(v) of a voxel with this code, −256 … 256 (rule 1).
[[nodiscard]] int regionSpeed(const ContourRule& rule, int code);
/// g(v) of a voxel, 1 … 255 (rule 2).
/// @param squaredMagnitude m
[[nodiscard]] int edgeWeight(const ContourRule& rule, std::uint64_t squaredMagnitude);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/FixedPoint.h"
#include "core/base/Result.h"
#include "core/sculpt/IntegerHalfSpace.h"
#include "core/sculpt/ProtectedLabels.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace core {

/// Three 64-bit fixed-point coordinates.
using Fixed3 = std::array<std::int64_t, 3>;

/// The plane from which a tool is pressed into the volume along the view direction (seed A §4.1,
/// 4.2), in integers: where it lies, what it meets and how it cuts. Drill, peel and scissors build
/// on it. Both engines follow these rules exactly.
///
/// Spaces: *plane* coordinates (x right, y up, z along the view direction) are mm from the view's
/// target, in 16.16 fixed point ("mm16") unless 2⁻³⁰ is stated. *Index* coordinates are voxels in
/// 16.16 ("index16") unless 2⁻³⁰ is stated. `>>` is the arithmetic shift (rounds down); round14(v)
/// is (v + 2¹³) >> 14 and converts 2⁻³⁰ to 2⁻¹⁶.
///
/// 1. Elements. The mask plane is a raster of square elements. Element (a, b) covers
///    [a·pitch, (a+1)·pitch) × [b·pitch, (b+1)·pitch); its centre is c = (a·pitch + pitch/2, …),
///    by integer division. Each tool says which elements it uses and how deep (DrillCut.h, rule 1).
/// 2. Rays. One ray is cast for each element that is used. P₀ = round14(rayOrigin + a·rayPerA +
///    b·rayPerB) and S = round14(rayPerSample), per component; if P₀ leaves ±2³⁰, the element cuts
///    nothing (it is far from the volume). The position at sample n plus q sixteenths is
///    P(n, q) = P₀ + n·S + ((q·S) >> 4), its height z(n, q) = zStart + n·zPerSample +
///    ((q·zPerSample) >> 4).
///    Rules 4 and 5 skip samples n whose P(n, 0) is hidden (IntegerHalfSpace.h): they use the
///    samples f ≤ n < e from the first to the last visible one.
/// 3. Material at P (index16). Voxels extend half their spacing beyond their centres: P is outside
///    unless −2¹⁵ ≤ P < (2·size − 1)·2¹⁵ in every component. P is clamped to 0 … (size − 1)·2¹⁶,
///    so that the outermost voxels extend to the border of the volume. i = P >> 16,
///    f = (P & 0xFFFF) >> 8, neighbours are clamped to size − 1. Codes are interpolated along x, y,
///    z: X = (c₀(256−f) + c₁f) >> 4, Y = (X₀(256−f) + X₁f) >> 4, Z = Y₀(256−f) + Y₁f, all in
///    unsigned 32 bits; P is dense if Z ≥ thresholdCode·2¹⁶ (thresholdCode 65536: never dense).
///    Radiation (Radiation.h) *as it was when the edit began* is interpolated in the same way
///    without the shifts; P is carved if the result ≥ 128·2²⁴. Material is inside, dense and not
///    carved.
///    Restoring uses whole voxels, so that it finds the walls where the cut left them: with
///    v = (P + 2¹⁵) >> 16, P is dense if the code of v ≥ thresholdCode, and carved if the
///    radiation of v ≥ 128. With `asWhole` nothing counts as carved.
/// 4. Surface. n₀ is the first sample f ≤ n < e with material at (n, 0); if there is none, the
///    element cuts nothing. For n₀ > f, four bisections of [(n₀−1)·16, n₀·16] in sixteenths follow
///    (middle = (low + high) / 2; material → high, else low); otherwise high is n₀·16.
///    zSurface = z(high / 16, high % 16).
///    Restoring: a sample is *hollow* if it is inside, dense and carved at (n, 0). n_c is the last
///    hollow sample before n₀ (before e if there is no n₀); n_o is the first sample of the run of
///    hollow ones that n_c ends. Four bisections of [n_c·16, (n_c+1)·16] (hollow → low, else high)
///    give zSurface = z(high); for n_o > f, four of [(n_o−1)·16, n_o·16] (hollow → high, else low)
///    give zOuter = z(high), else zOuter = z(n_o, 0). If there is an n₀ but no n_c, and if a
///    sample n ≥ f before n₀ with z(n₀, 0) − z(n, 0) ≤ 2·front is inside and carved (only voxels in
///    front of the surface were), then zSurface = zOuter = z(n₀, 0). Otherwise the element restores
///    nothing. zExit holds zOuter.
/// 5. Gap. From n₀ + 1 on, while n < e and z(n, 0) ≤ zSurface + maxDepth, the first run of
///    gapSamples consecutive samples without material at (n, 0) ends the cut at
///    zExit = z(first of the run, 0). A run that the end of the samples cuts short does not count.
///    Without such a run, or with throughGaps, zExit = 2³¹ − 1.
/// 6. Voxels. For a brick with first voxel o: base = round14(planeOrigin + o.x·planePerI +
///    o.y·planePerJ + o.z·planePerK). For the voxel at local (i, j, k):
///    (x, y, z) = base + i·round14(planePerI) + j·round14(planePerJ) + k·round14(planePerK).
///    Its element is a = ⌊x / pitch⌋, b = ⌊y / pitch⌋. If that has a column (zFrom, zTo, weight
///    0 … 255) and the voxel is not hidden, then with r = rampHalfWidth
///    ramp(t) = ((clamp(t, −r, r) + r)·255) / (2r),
///    cut = min(weight, ramp(zTo − z), ramp(z − zFrom)).
///    Laying::Carve: coverage = max(coverage, cut), unless the voxel's label is protected
///    (ProtectedLabels.h).
///    Laying::Refill: with v = min(coverage, 255 − cut), coverage = v if v > cut, else 0. So
///    refilling exactly what a cut removed leaves nothing of the cut, and the order in which ever
///    greater cuts are refilled does not matter.
/// 7. Columns when restoring to depth D from what rule 4 found: (zFrom, zSurface + front/2 + r)
///    with zFrom = min(zSurface − D, zSurface − front/2 − r), so that the last voxel returns in any
///    case. But if zFrom − zOuter ≤ front − r/8, everything that was removed returns: zFrom =
///    zOuter − 2·front − 2r. All divisions here are by >>.
struct CutFrame {
    Fixed3 planeOrigin{}; ///< plane coordinates of voxel (0, 0, 0), mm · 2³⁰
    Fixed3 planePerI{}; ///< change per voxel along i, mm · 2³⁰
    Fixed3 planePerJ{};
    Fixed3 planePerK{};
    Fixed3 rayOrigin{}; ///< index coordinates of the centre of element (0, 0) at zStart, · 2³⁰
    Fixed3 rayPerA{};
    Fixed3 rayPerB{};
    Fixed3 rayPerSample{};
    std::int32_t pitch = 0; ///< side of an element, mm16
    std::int32_t zStart = 0; ///< mm16; in front of the volume
    std::int32_t zPerSample = 0; ///< mm16
    std::int32_t sampleCount = 0; ///< enough to end behind the volume
    std::int32_t rampHalfWidth = 0; ///< mm16, half the finest spacing
    /// mm16: how far in front of the surface a cut begins, so that the voxels on both sides of the
    /// surface are cut, however far apart they lie along the view. Otherwise the values
    /// interpolated between them would remain as a skin, which the next press would meet.
    std::int32_t front = 0;
    std::int32_t thresholdCode = 0; ///< the surface: codes ≥ this are visible
    std::int32_t maxDepth = 0; ///< mm16; no cut is deeper
    std::int32_t gapSamples = 0; ///< ≥ 1
    bool throughGaps = false;
    bool restore = false; ///< refill instead of carve: rules 3, 4 and 7
    bool asWhole = false; ///< rule 3
    std::vector<IntegerHalfSpace> hidden{}; ///< what the clip box and clip planes hide
    ProtectedLabels protectedLabels{}; ///< voxels with these labels are not carved
};

/// What the ray of an element met: rules 4 and 5.
struct SurfaceHit {
    static constexpr std::int32_t none = 0x7FFFFFFF;
    std::int32_t zSurface = none; ///< none: no surface
    std::int32_t zExit = none; ///< when restoring: zOuter
};

/// How far the ray of an element searched for its surface at most (rule 4), as far as the hit
/// shows: zSurface; or, if it met none or restores (it searches behind what it found), the last
/// sample inside the volume; none if no sample lies inside. The greatest over the elements of an
/// edit is EditStatistics::searchedTo.
[[nodiscard]] std::optional<std::int32_t> searchEnd(const CutFrame& frame,
    const glm::ivec3& volumeSize, const glm::ivec2& element, const SurfaceHit& hit);

/// What an element cuts: rule 6.
struct CutColumn {
    std::int32_t zFrom = 0; ///< mm16
    std::int32_t zTo = 0; ///< mm16
    std::int32_t weight = 0; ///< 0: nothing
    bool operator==(const CutColumn&) const = default;
};

/// How a cut changes the coverage of a layer: rule 6.
enum class Laying : std::uint8_t { Carve, Refill };

/// Rule 6: the coverage that remains after a cut was refilled.
[[nodiscard]] constexpr std::uint8_t refilled(std::uint8_t coverage, std::uint8_t cut)
{
    const int left = coverage < 255 - cut ? coverage : 255 - cut;
    return std::uint8_t(left > cut ? left : 0);
}

/// A rectangle of mask elements, both ends included.
struct ElementBox {
    glm::ivec2 minimum{0};
    glm::ivec2 maximum{-1};
};

namespace fixedPoint {

/// Each component: 2⁻³⁰ to 2⁻¹⁶.
[[nodiscard]] inline glm::ivec3 round14(const Fixed3& v)
{
    return {int(round14(v[0])), int(round14(v[1])), int(round14(v[2]))};
}

} // namespace fixedPoint

/// Rule 7. @param from zSurface − D; @param weight of the column
[[nodiscard]] CutColumn restoringColumn(
    const CutFrame& frame, const SurfaceHit& hit, std::int32_t from, std::int32_t weight);

/// Rule 6: plane coordinates of a brick's first voxel.
[[nodiscard]] glm::ivec3 planeBase(const CutFrame& frame, const glm::ivec3& firstVoxel);

/// Whether its numbers are ones that the rules allow. Errors: InvalidField.
[[nodiscard]] Result<void> checkSound(const CutFrame& frame);

} // namespace core

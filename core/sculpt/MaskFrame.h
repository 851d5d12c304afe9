// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sculpt/HiddenHalf.h"
#include "core/sculpt/SparedLabels.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace core {

/// Three 64-bit fixed-point coordinates.
using Fixed3 = std::array<std::int64_t, 3>;

/// The plane that a tool presses into the volume along the view direction (seed A §4.1, 4.2), in
/// integers: where it lies, what it meets, how it cuts. Drill, peel and scissors build on it; both
/// engines follow the rules below to the bit.
///
/// Spaces. *Plane* coordinates (x right, y up, z along the view direction) are mm from the view's
/// target, in 16.16 fixed point ("mm16") unless 2⁻³⁰ is said. *Index* coordinates are voxels, 16.16
/// ("index16") unless 2⁻³⁰ is said. `>>` is the arithmetic shift (rounds down); round14(v) is
/// (v + 2¹³) >> 14 and brings 2⁻³⁰ to 2⁻¹⁶.
///
/// 1. Elements. The mask plane is a raster of square elements; element (a, b) covers
///    [a·pitch, (a+1)·pitch) × [b·pitch, (b+1)·pitch), centre c = (a·pitch + pitch/2, …) (integer
///    division). Each tool says which elements it uses and how deep (DrillCut.h, rule 1).
/// 2. Rays. Every element that is used is cast once. P₀ = round14(rayOrigin + a·rayPerA +
///    b·rayPerB), S = round14(rayPerSample), per component; where P₀ leaves ±2³⁰ the element cuts
///    nothing (it lies far from the volume). The position at sample n plus q sixteenths is
///    P(n, q) = P₀ + n·S + ((q·S) >> 4), its height z(n, q) = zStart + n·zPerSample +
///    ((q·zPerSample) >> 4).
///    Samples n whose P(n, 0) is hidden (HiddenHalf.h) are passed over by rules 4 and 5, as if the
///    ray had none there: it has those from the first that is seen to the last, f ≤ n < e.
/// 3. Material at P (index16). Voxels reach half their spacing beyond their centres: outside unless
///    −2¹⁵ ≤ P < (2·size − 1)·2¹⁵ in every component. P is clamped to 0 … (size − 1)·2¹⁶, so that
///    the outermost voxels go on to the border of the volume.
///    i = P >> 16, f = (P & 0xFFFF) >> 8, neighbours clamped to size − 1. Codes are interpolated
///    along x, y, z: X = (c₀(256−f) + c₁f) >> 4, Y = (X₀(256−f) + X₁f) >> 4, Z = Y₀(256−f) + Y₁f,
///    all in unsigned 32 bits; dense iff Z ≥ thresholdCode·2¹⁶ (thresholdCode 65536: never dense).
///    Radiation (see Radiation.h) *as it was when the edit began* is interpolated alike without the
///    shifts; carved iff the result ≥ 128·2²⁴. Material = inside, dense and not carved.
///    Restoring looks at voxels as a whole, so that it finds the walls where the cut left them:
///    with v = (P + 2¹⁵) >> 16, dense iff the code of v ≥ thresholdCode, carved iff the radiation
///    of v ≥ 128. Where `asWhole` is on nothing counts as carved.
/// 4. Surface. n₀ = the first sample f ≤ n < e with material at (n, 0); none: the element cuts
///    nothing. For n₀ > f four bisections of [(n₀−1)·16, n₀·16] in sixteenths (middle =
///    (low + high) / 2; material → high, else low), else (0, 0);
///    zSurface = z(high / 16, high % 16).
///    Restoring: n_c = the last sample before n₀ (before e where there is no n₀) that is *hollow*:
///    inside, dense and carved at (n, 0); n_o = the first of the run of hollow ones that it ends.
///    Four bisections each: of [n_c·16, (n_c+1)·16] (hollow → low, else high), zSurface = z(high);
///    for n_o > f of [(n_o−1)·16, n_o·16] (hollow → high, else low), zOuter = z(high), else
///    zOuter = z(n_o, 0). There being no n_c but an n₀, and before it a sample n ≥ f with z(n₀, 0)
///    − z(n, 0) ≤ 2·front that is inside and carved (in front of the surface only): zSurface =
///    zOuter = z(n₀, 0). Else the element restores nothing. zExit holds zOuter.
/// 5. Gap. From n₀ + 1 on, while n < e and z(n, 0) ≤ zSurface + maxDepth: the first run
///    of gapSamples consecutive samples without material (at (n, 0)) ends the cut at
///    z(first of the run, 0) =: zExit. A run cut short by the end of the march does not count. No
///    such run, or throughGaps: zExit = 2³¹ − 1.
/// 6. Voxels. For a brick with first voxel o: base = round14(planeOrigin + o.x·planePerI +
///    o.y·planePerJ + o.z·planePerK), and for the voxel at local (i, j, k):
///    (x, y, z) = base + i·round14(planePerI) + j·round14(planePerJ) + k·round14(planePerK).
///    Its element a = ⌊x / pitch⌋, b = ⌊y / pitch⌋ has a column (zFrom, zTo, weight 0 … 255), or
///    none, and then nothing happens. With r = rampHalfWidth,
///    ramp(t) = ((clamp(t, −r, r) + r)·255) / (2r),
///    cut = min(weight, ramp(zTo − z), ramp(z − zFrom)).
///    Nothing happens to a voxel that is hidden.
///    Laying::Carve: coverage = max(coverage, cut), unless the voxel is spared (SparedLabels.h).
///    Laying::Refill: with v = min(coverage, 255 − cut), coverage = v where v > cut, else 0. So
///    what one cut had taken is gone, to the last bit, after the same was refilled; and the order
///    in which ever greater cuts are refilled does not matter.
/// 7. Columns while restoring D deep from what rule 4 found: (zFrom, zSurface + front/2 + r) with
///    zFrom = min(zSurface − D, zSurface − front/2 − r): the last voxel comes back in any case. But
///    where zFrom − zOuter ≤ front − r/8, all that was taken does: zFrom = zOuter − 2·front − 2r.
///    All divisions are by >>.
struct MaskFrame {
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
    /// mm16: a cut begins so far in front of the surface that the voxels on both sides of it are
    /// cut, however far they lie apart along the view. Else what is interpolated between them would
    /// stay as a skin, and the next press would meet that.
    std::int32_t front = 0;
    std::int32_t thresholdCode = 0; ///< the surface: codes ≥ this are seen
    std::int32_t maxDepth = 0; ///< mm16, no cut reaches deeper
    std::int32_t gapSamples = 0; ///< ≥ 1
    bool throughGaps = false;
    bool restore = false; ///< the tool backwards: rules 3, 4 and 7
    bool asWhole = false; ///< rule 3
    std::vector<HiddenHalf> hidden{}; ///< what a clip box or planes hide
    SparedLabels spared{}; ///< what is not carved
};

/// What an element met: rules 4 and 5.
struct SurfaceHit {
    static constexpr std::int32_t none = 0x7FFFFFFF;
    std::int32_t zSurface = none; ///< none: nothing
    std::int32_t zExit = none; ///< restoring: zOuter
};

/// How far an element that was cast looked for its surface at most (rule 4), as far as a hit tells:
/// zSurface, or the last sample inside the volume for one that met none, or for any that restores
/// (it looks behind what it found); none where no sample lies inside. Of an edit the greatest over
/// its elements is EditStatistics::searchedTo.
[[nodiscard]] std::optional<std::int32_t> searchEnd(const MaskFrame& frame,
    const glm::ivec3& volumeSize, const glm::ivec2& element, const SurfaceHit& hit);

/// What an element does: rule 6.
struct MaskColumn {
    std::int32_t zFrom = 0; ///< mm16
    std::int32_t zTo = 0; ///< mm16
    std::int32_t weight = 0; ///< 0: nothing
    bool operator==(const MaskColumn&) const = default;
};

/// How a cut is laid into a layer.
enum class Laying : std::uint8_t { Carve, Refill };

/// Rule 6: what is left of coverage where a cut is refilled.
[[nodiscard]] constexpr std::uint8_t refilled(std::uint8_t coverage, std::uint8_t cut)
{
    const int left = coverage < 255 - cut ? coverage : 255 - cut;
    return std::uint8_t(left > cut ? left : 0);
}

/// A stretch of mask elements, both ends included.
struct ElementBox {
    glm::ivec2 minimum{0};
    glm::ivec2 maximum{-1};
};

/// The integer arithmetic of these rules.
namespace fixedPoint {

/// 2⁻³⁰ to 2⁻¹⁶.
[[nodiscard]] constexpr std::int64_t round14(std::int64_t value)
{
    return (value + (1 << 13)) >> 14;
}
[[nodiscard]] inline glm::ivec3 round14(const Fixed3& v)
{
    return {int(round14(v[0])), int(round14(v[1])), int(round14(v[2]))};
}

/// Rounds down, for divisors above 0.
[[nodiscard]] constexpr std::int32_t floorDivide(std::int64_t value, std::int32_t divisor)
{
    return std::int32_t(value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor));
}

/// ⌊√value⌋.
[[nodiscard]] std::int64_t squareRoot(std::int64_t value);

} // namespace fixedPoint

/// Rule 7. @param from zSurface − D; @param weight of the column
[[nodiscard]] MaskColumn restoringColumn(
    const MaskFrame& frame, const SurfaceHit& hit, std::int32_t from, std::int32_t weight);

/// Rule 6: plane coordinates of a brick's first voxel.
[[nodiscard]] glm::ivec3 planeBase(const MaskFrame& frame, const glm::ivec3& firstVoxel);

/// Whether its numbers are ones that the rules allow. Errors: InvalidField.
[[nodiscard]] Result<void> checkSound(const MaskFrame& frame);

} // namespace core

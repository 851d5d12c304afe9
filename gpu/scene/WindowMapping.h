// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <glm/glm.hpp>

namespace gpu {

/// Coefficients (x, y) of: modality value = x · texel + y, for a texel of the R16 intensity (code /
/// 65535).
[[nodiscard]] glm::dvec2 valueOfTexel(const core::VoxelEncoding& encoding);

/// How far the values of two neighbouring codes are apart.
[[nodiscard]] double valuesApart(const core::VoxelEncoding& encoding);

/// The modality values over which greys rise: black up to middle − span/2, white from middle +
/// span/2 on.
struct GreyRamp {
    double middle = 0.0;
    double span = 1.0;
};

/// The ramp of a window. Where values are one apart it is that of DICOM PS3.3 C.11.2.1.2.1, LINEAR:
/// middle centre − 0.5, span width − 1, and widths of 1 and less become a step. All other values
/// get the ramp of C.11.2.1.3.2, LINEAR_EXACT: middle centre, span width. LINEAR is meant for whole
/// numbers, of which a window of width n shows n; for a fraction, an SUV or an ADC, one unit is as
/// large as the whole window. The rule also holds for a file that states LINEAR and has a
/// fractional slope: the ends of the window then move by half a unit at most, which is invisible in
/// the windows for which LINEAR is meant, and a rule that also depended on the width would jump
/// while the width is dragged.
[[nodiscard]] GreyRamp greyRampOf(
    const core::VoxelEncoding& encoding, const core::WindowLevel& window);

/// The least width to which a window is narrowed: a narrower one would distinguish no more values.
[[nodiscard]] double leastWindowWidth(const core::VoxelEncoding& encoding);

/// Coefficients (x, y) of: grey (to be clamped to 0 … 1) = x · texel + y, on the ramp of the
/// window.
[[nodiscard]] glm::dvec2 greyOfTexel(
    const core::VoxelEncoding& encoding, const core::WindowLevel& window);

} // namespace gpu

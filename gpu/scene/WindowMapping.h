// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <glm/glm.hpp>

namespace gpu {

/// Coefficients (x, y) of: modality value = x · texel + y, for a texel of the R16 intensity (code /
/// 65535).
[[nodiscard]] glm::dvec2 valueOfTexel(const core::VoxelEncoding& encoding);

/// Coefficients (x, y) of: grey (to be clamped to 0 … 1) = x · texel + y, by DICOM PS3.3
/// C.11.2.1.2, LINEAR: black up to centre − 0.5 − (width − 1)/2, white from centre − 0.5 + (width −
/// 1)/2 on. Widths of 1 and less become a step.
[[nodiscard]] glm::dvec2 greyOfTexel(
    const core::VoxelEncoding& encoding, const core::WindowLevel& window);

} // namespace gpu

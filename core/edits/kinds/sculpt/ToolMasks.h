// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sculpt/MaskRaster.h"

#include <vector>

namespace core {

struct MaskShape;

// From outlines in millimetres to rasters of elements.

/// Round masks are exact circles, whatever the element; all others are rasters.
[[nodiscard]] bool isRound(const MaskShape& shape);

/// How far the outline lies from the sample at most.
[[nodiscard]] double reachMm(const MaskShape& shape);

/// Corners of the outline, counter-clockwise unless it is a polygon; round parts in pieces that
/// leave the true curve by less than 1/64 of @p elementMm.
[[nodiscard]] std::vector<glm::dvec2> outlineMm(const MaskShape& shape, double elementMm);

/// An outline on a plane of elements: filled, and its edge smoothed (MaskRaster.h).
/// @param origin where (0, 0) of the outline lies, in elements
/// Errors: InvalidField (@p field: what it covers is smaller than one element).
[[nodiscard]] Result<MaskRaster> maskOf(const std::vector<glm::dvec2>& outlineMm,
    std::int32_t pitch, const glm::dvec2& origin, const QString& field);

/// The mask of a tool that is pressed into the volume, its soft edge included: the outline stands
/// in the middle of element (0, 0). Errors: as above.
[[nodiscard]] Result<MaskRaster> maskUnderSample(
    const MaskShape& shape, std::int32_t pitch, const QString& field);

} // namespace core

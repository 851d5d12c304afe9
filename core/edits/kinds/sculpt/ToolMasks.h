// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sculpt/OutlineRaster.h"

#include <vector>

namespace core {

struct ToolMask;

// Converts outlines in millimetres to rasters of elements.

/// Round masks are exact circles, whatever the element; all others are rasters.
[[nodiscard]] bool isRound(const ToolMask& shape);

/// The greatest distance of the outline from the sample.
[[nodiscard]] double reachMm(const ToolMask& shape);

/// The corners of the outline, counter-clockwise unless it is a polygon. Curves are approximated to
/// less than 1/64 of @p elementMm.
[[nodiscard]] std::vector<glm::dvec2> outlineMm(const ToolMask& shape, double elementMm);

/// The raster of an outline on a plane of elements: filled, with a smooth edge (OutlineRaster.h).
/// @param origin where (0, 0) of the outline lies, in elements
/// Errors: InvalidField (@p field: it covers less than one element).
[[nodiscard]] Result<OutlineRaster> maskOf(const std::vector<glm::dvec2>& outlineMm,
    std::int32_t pitch, const glm::dvec2& origin, const QString& field);

/// The raster of a tool's mask, including its soft edge; the outline is centred in element (0, 0).
/// Errors: as above.
[[nodiscard]] Result<OutlineRaster> maskUnderSample(
    const ToolMask& shape, std::int32_t pitch, const QString& field);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <optional>
#include <utility>
#include <vector>

class QPainter;

namespace ui {

class CuttingPlane;

/// The two ends (LPS) of the line where a plane meets a slice.
/// @param section of the plane and the volume, as corners in order
[[nodiscard]] std::optional<std::pair<glm::dvec3, glm::dvec3>> lineAcross(
    const ViewContext& slice, const std::vector<glm::dvec3>& section);

/// The two ends (LPS) of the line where the cutting plane meets a slice, within the volume. None if
/// it does not meet it, lies in it, or is hidden.
[[nodiscard]] std::optional<std::pair<glm::dvec3, glm::dvec3>> planeLine(
    const ViewContext& slice, const CuttingPlane& plane);

/// Draws that line, with ticks to the side above the plane.
void paintPlaneLine(QPainter& painter, const ViewContext& slice, const CuttingPlane& plane);

} // namespace ui

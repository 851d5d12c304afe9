// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <optional>
#include <utility>

class QPainter;

namespace ui {

class CuttingPlane;

/// Where the cutting plane meets a slice, within the volume: both ends, LPS. None: it does not, or
/// lies in it, or is hidden.
[[nodiscard]] std::optional<std::pair<glm::dvec3, glm::dvec3>> planeLine(
    const ViewContext& slice, const CuttingPlane& plane);

/// That line, with ticks to the side that is above the plane; nothing where there is none.
void paintPlaneLine(QPainter& painter, const ViewContext& slice, const CuttingPlane& plane);

} // namespace ui

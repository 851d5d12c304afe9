// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonArray>
#include <QJsonValue>

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace ui {

/// The outline of a mask (tool footprint) drawn by hand, as settings and presets store it: x to the
/// right, y up, the middle at 0, the longer side from −1 to 1. The curve is closed implicitly and
/// may cross itself; empty if none is drawn.
using ToolMaskOutline = std::vector<glm::dvec2>;

/// A mask's outline as it was drawn, with its size.
struct DrawnToolMask {
    ToolMaskOutline outline;
    double radiusMm = 0.0; ///< half of its longer side, as it was drawn
};

/// Converts a drawn curve; none if the curve covers next to no area.
/// @param toleranceMm points that change the curve by less are dropped
[[nodiscard]] std::optional<DrawnToolMask> drawnToolMask(
    const std::vector<glm::dvec2>& curveMm, double toleranceMm);

[[nodiscard]] QJsonArray outlineJson(const ToolMaskOutline& outline);
/// Empty if the value is not an outline.
[[nodiscard]] ToolMaskOutline outlineFromJson(const QJsonValue& json);

} // namespace ui

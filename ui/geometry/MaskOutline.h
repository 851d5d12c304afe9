// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonArray>
#include <QJsonValue>

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace ui {

/// A mask's outline drawn by hand, as settings and presets keep it: right and up, its middle at 0,
/// its greater side from −1 to 1. It closes by itself and may cross itself; empty: none is drawn.
using MaskOutline = std::vector<glm::dvec2>;

struct DrawnMask {
    MaskOutline outline;
    double radiusMm = 0.0; ///< half its greater side, as it was drawn
};

/// None: the curve covers next to nothing.
/// @param toleranceMm points that change the curve by less are left out
[[nodiscard]] std::optional<DrawnMask> drawnMask(
    const std::vector<glm::dvec2>& curveMm, double toleranceMm);

[[nodiscard]] QJsonArray outlineJson(const MaskOutline& outline);
/// Empty: what is there is no outline.
[[nodiscard]] MaskOutline outlineFromJson(const QJsonValue& json);

} // namespace ui

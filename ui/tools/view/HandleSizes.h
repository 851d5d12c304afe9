// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>

#include <cmath>

namespace ui {

/// Radius in pixels with which handles of the clip box and of the cutting plane are drawn.
constexpr double handleRadius = 6.0;
/// Radius in pixels around a handle's centre within which a press takes hold of it.
constexpr double handleGripRadius = 14.0;

[[nodiscard]] inline double distance(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace ui

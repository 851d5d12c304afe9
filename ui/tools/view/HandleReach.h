// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPointF>

#include <cmath>

namespace ui {

/// Handles of the clip box and of the cutting plane look and are hit alike; in pixels.
constexpr double handleRadius = 6.0;
/// How far from its middle a handle is still taken.
constexpr double handleReach = 14.0;

[[nodiscard]] inline double distance(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace ui

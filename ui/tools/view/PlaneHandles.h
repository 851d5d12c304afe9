// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace ui {

class CuttingPlane;

/// What the cutting plane is moved and turned by in a picture.
struct PlaneHandle {
    int id = 0; ///< the same from picture to picture
    bool turns = false; ///< about axisLps through the plane's centre; else it moves it along that
    glm::dvec3 axisLps{0.0}; ///< unit
    QPointF pixel;
    QPointF pixelsPerUnit; ///< a millimetre, or a radian
    std::optional<QPointF>
        pivot; ///< that it goes round in the picture; none: the picture is aslant
};

/// Those that can be dragged in a view: in slices on the plane's line, in the 3D view on its
/// rectangle. What would hardly move in the picture is left out.
[[nodiscard]] std::vector<PlaneHandle> planeHandles(
    const ViewContext& view, const CuttingPlane& plane);

/// Whether a view is a slice in the cutting plane itself.
[[nodiscard]] bool showsPlaneItself(const ViewContext& view, const CuttingPlane& plane);

/// The plane goes with a handle that is dragged by the pointer.
void dragPlane(CuttingPlane& plane, const PlaneHandle& handle, const QPointF& fromPixel,
    const QPointF& toPixel);

/// Radians from one place to another round a pivot, clockwise in the picture.
[[nodiscard]] double turnAround(
    const QPointF& pivot, const QPointF& fromPixel, const QPointF& toPixel);

} // namespace ui

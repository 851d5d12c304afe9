// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace ui {

class CuttingPlane;

/// A handle by which the user moves or turns the cutting plane in a picture.
struct PlaneHandle {
    int id = 0; ///< stays the same from picture to picture
    /// true: turns about axisLps through the plane's centre; false: moves along axisLps
    bool turns = false;
    glm::dvec3 axisLps{0.0}; ///< unit
    QPointF pixel;
    QPointF pixelsPerUnit; ///< movement of the handle per millimetre, or per radian
    std::optional<QPointF>
        pivot; ///< the point it turns around in the picture; none if the picture is oblique
};

/// The handles that can be dragged in a view: in slices on the line of the plane, in the 3D view on
/// its rectangle. Handles that would hardly move in the picture are left out.
[[nodiscard]] std::vector<PlaneHandle> planeHandles(
    const ViewContext& view, const CuttingPlane& plane);

/// Whether a view is a slice in the cutting plane itself.
[[nodiscard]] bool showsPlaneItself(const ViewContext& view, const CuttingPlane& plane);

/// Moves the plane with a handle that is dragged by the pointer.
void dragPlane(CuttingPlane& plane, const PlaneHandle& handle, const QPointF& fromPixel,
    const QPointF& toPixel);

/// The angle in radians from one point to another around a pivot, clockwise in the picture.
[[nodiscard]] double turnAround(
    const QPointF& pivot, const QPointF& fromPixel, const QPointF& toPixel);

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/Camera.h"

#include <QPointF>

#include <optional>

class QPainter;

namespace ui {

/// The small cube that shows the orientation of the patient in a 3D view, with orientation letters
/// on its faces.
class OrientationCube {
public:
    /// @param centre and @param edge in pixels
    OrientationCube(const Camera& camera, const QPointF& centre, double edge);

    void paint(QPainter& painter) const;
    /// The side of the patient (outward direction) whose face is at a pixel; none outside the cube.
    [[nodiscard]] std::optional<glm::dvec3> sideAt(const QPointF& pixel) const;

private:
    struct Face;
    [[nodiscard]] std::optional<Face> faceTowards(const glm::dvec3& side) const;

    glm::dvec3 m_right;
    glm::dvec3 m_up;
    glm::dvec3 m_towardsViewer;
    QPointF m_centre;
    double m_edge;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <QPolygonF>

#include <glm/glm.hpp>

#include <optional>
#include <vector>

class QPainter;

namespace ui {

/// A curve that the user draws on the 3D view (seed A §4.1). It is closed implicitly, if it is no
/// Line, and may cross itself. The view at pen-down is used until the curve is finished.
class CurveSketch {
public:
    enum class Shape {
        Freehand,
        Rectangle, ///< of a drag from corner to corner
        Ellipse, ///< the one within that rectangle
        Line, ///< does not close, but goes on straight at its ends (LineAcross.h)
    };

    void begin(const QPointF& at, const ViewContext& view, Shape shape = Shape::Freehand);
    void extend(const QPointF& at);
    void drop() { m_view.reset(); }

    [[nodiscard]] bool drawing() const { return m_view.has_value(); }
    /// The view at pen-down; only while drawing.
    [[nodiscard]] const ViewContext& view() const { return *m_view; }
    /// The curve drawn so far, in millimetres in the view plane, right of and above the target.
    [[nodiscard]] std::vector<glm::dvec2> curveMm() const;
    /// The same, and ends the drawing. Empty if the curve is too small to be intended.
    [[nodiscard]] std::vector<glm::dvec2> finish();

    /// The same in logical pixels.
    [[nodiscard]] QPolygonF polygon() const;

    void paint(QPainter& painter) const;

private:
    Shape m_shape = Shape::Freehand;
    std::optional<ViewContext> m_view; ///< set while drawing
    QPolygonF m_points; ///< logical pixels; of a drag both ends
};

} // namespace ui

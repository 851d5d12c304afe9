// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <QPolygonF>

#include <glm/glm.hpp>

#include <vector>

namespace ui {

/// A closed outline that is being drawn on a slice. It lies in the plane that the slice had when it
/// was begun, so the picture may be moved and zoomed while a polygon is open.
class SliceOutline {
public:
    enum class Shape {
        Lasso, ///< a freehand curve
        Polygon, ///< corner by corner
        Rectangle, ///< of a drag from corner to corner
        Ellipse, ///< the one within that rectangle
        Livewire, ///< along edges of the picture, from anchor to anchor
        Level, ///< the contour of a value
    };

    /// @param view a slice
    void begin(Shape shape, const QPointF& at, const ViewContext& view);
    /// One whose corners were found in the picture of a view.
    void lay(Shape shape, const std::vector<glm::dvec3>& cornersLps, const ViewContext& view);
    /// Other corners in the plane that it has.
    void setCorners(const std::vector<glm::dvec3>& cornersLps);
    void drop() { m_points.clear(); }
    [[nodiscard]] bool drawing() const { return !m_points.empty(); }
    [[nodiscard]] Shape shape() const { return m_shape; }
    /// Whether the view shows the plane of the outline.
    [[nodiscard]] bool liesIn(const ViewContext& view) const;

    /// The pen went on while it was down: a curve gets longer, the last corner moves.
    void extend(const QPointF& at, const ViewContext& view);
    // Of a polygon; a click ends a wire at the same places.
    void addCorner(const QPointF& at, const ViewContext& view);
    /// Takes the last corner back; without corners it is no longer drawn.
    void removeCorner() { m_points.pop_back(); }
    /// Whether a click there ends the polygon instead of adding a corner: on the first corner, or
    /// on the last one for a second time.
    [[nodiscard]] bool endsAt(const QPointF& at, const ViewContext& view) const;

    // The plane: edits have it in this form (core/edits/kinds/segments/FillOutline.h).
    [[nodiscard]] const glm::dvec3& originLps() const { return m_originLps; }
    [[nodiscard]] const glm::dvec3& rightLps() const { return m_rightLps; }
    [[nodiscard]] const glm::dvec3& upLps() const { return m_upLps; }
    /// What is drawn so far, closed from the last corner to the first.
    [[nodiscard]] std::vector<glm::dvec2> polygonMm() const;
    /// Whether that is large enough on the screen to be intended.
    [[nodiscard]] bool isMeant(const ViewContext& view) const;

    /// In logical pixels of a view that shows its plane.
    [[nodiscard]] QPolygonF pixels(const ViewContext& view) const;
    [[nodiscard]] QPointF firstPixel(const ViewContext& view) const;

private:
    void lieIn(const ViewContext& view);
    [[nodiscard]] glm::dvec2 inPlane(const glm::dvec3& placeLps) const;
    [[nodiscard]] glm::dvec2 inPlane(const QPointF& at, const ViewContext& view) const;
    [[nodiscard]] QPointF toPixel(const glm::dvec2& place, const ViewContext& view) const;

    Shape m_shape = Shape::Lasso;
    glm::dvec3 m_originLps{0.0};
    glm::dvec3 m_rightLps{1.0, 0.0, 0.0};
    glm::dvec3 m_upLps{0.0, 1.0, 0.0};
    /// mm, right of and above the origin: all of a curve, corners of a polygon, both ends of a drag
    std::vector<glm::dvec2> m_points;
};

} // namespace ui

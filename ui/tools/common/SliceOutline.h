// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <QPolygonF>

#include <glm/glm.hpp>

#include <vector>

namespace ui {

/// A closed outline that the user draws on a slice. It stays in the plane of the slice in which it
/// was begun, so the view may be panned and zoomed while a polygon is open.
class SliceOutline {
public:
    enum class Shape {
        Lasso, ///< a freehand curve
        Polygon, ///< corner by corner
        Rectangle, ///< from a drag between two corners
        Ellipse, ///< inscribed in that rectangle
        Livewire, ///< follows edges of the picture from anchor to anchor (LiveWire)
        Level, ///< the contour of a value (LevelTrace)
    };

    /// Starts an outline.
    /// @param at logical pixels of the view
    /// @param view shows a slice
    void begin(Shape shape, const QPointF& at, const ViewContext& view);
    /// Replaces it by an outline whose corners were computed from the picture of a view.
    void lay(Shape shape, const std::vector<glm::dvec3>& cornersLps, const ViewContext& view);
    /// Replaces the corners; the plane stays.
    void setCorners(const std::vector<glm::dvec3>& cornersLps);
    /// Removes the outline.
    void drop() { m_points.clear(); }
    [[nodiscard]] bool drawing() const { return !m_points.empty(); }
    [[nodiscard]] Shape shape() const { return m_shape; }
    /// Whether the view shows the plane in which the outline lies.
    [[nodiscard]] bool liesIn(const ViewContext& view) const;

    /// Follows the pen while it is down: a curve gets longer; of other shapes the last corner
    /// moves.
    void extend(const QPointF& at, const ViewContext& view);
    // For polygons. A livewire is closed by clicks at the same places.
    void addCorner(const QPointF& at, const ViewContext& view);
    /// Removes the last corner. Without corners there is no outline any more.
    void removeCorner() { m_points.pop_back(); }
    /// Whether a click at this position closes the polygon instead of adding a corner: it is on the
    /// first corner, or again on the last one.
    [[nodiscard]] bool endsAt(const QPointF& at, const ViewContext& view) const;

    // The plane, in the form in which edits have it (core/edits/kinds/segments/FillOutline.h).
    [[nodiscard]] const glm::dvec3& originLps() const { return m_originLps; }
    [[nodiscard]] const glm::dvec3& rightLps() const { return m_rightLps; }
    [[nodiscard]] const glm::dvec3& upLps() const { return m_upLps; }
    /// What is drawn so far, in mm to the right of and above originLps(); the last corner is joined
    /// to the first.
    [[nodiscard]] std::vector<glm::dvec2> polygonMm() const;
    /// Whether the outline is large enough on the screen to be intentional.
    [[nodiscard]] bool isMeant(const ViewContext& view) const;

    /// The outline in logical pixels of a view that shows its plane.
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
    /// In mm right of and above the origin: all points of a curve, the corners of a polygon, or
    /// both ends of a drag.
    std::vector<glm::dvec2> m_points;
};

} // namespace ui

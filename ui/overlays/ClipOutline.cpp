// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/ClipOutline.h"

#include "ui/base/Theme.h"

#include <QPainter>

#include <cmath>

namespace ui {

namespace {

QColor boxColour()
{
    return theme::accent;
}

QColor planeColour()
{
    return theme::caution;
}

void drawLine(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour)
{
    QColor shadow(0, 0, 0, 110);
    shadow.setAlphaF(shadow.alphaF() * colour.alphaF());
    painter.setPen(QPen(shadow, 2.6));
    painter.drawLine(from, to);
    painter.setPen(QPen(colour, 1.1));
    painter.drawLine(from, to);
}

void drawPolygon(QPainter& painter, const QPolygonF& polygon, const QColor& colour)
{
    for (qsizetype i = 0; i < polygon.size(); ++i)
        drawLine(painter, polygon[i], polygon[(i + 1) % polygon.size()], colour);
}

/// Where a polygon's sides pass through a plane.
std::vector<glm::dvec3> crossings(
    const std::vector<glm::dvec3>& polygon, const glm::dvec3& pointLps, const glm::dvec3& normalLps)
{
    std::vector<glm::dvec3> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& from = polygon[i];
        const glm::dvec3& to = polygon[(i + 1) % polygon.size()];
        const double before = glm::dot(from - pointLps, normalLps);
        const double after = glm::dot(to - pointLps, normalLps);
        if ((before < 0.0) != (after < 0.0))
            result.push_back(from + (to - from) * (before / (before - after)));
    }
    return result;
}

void paintPlaneLine(QPainter& painter, const ViewContext& view, const core::ClipPlane& plane,
    const core::VolumeGeometry& geometry)
{
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const auto section = core::boxSection(
        core::wholeVolume(geometry).box, geometry, plane.pointLps, plane.normalLps);
    const auto ends =
        crossings(section, slice.centreLps, glm::cross(slice.rightLps, slice.downLps));
    if (ends.size() != 2)
        return;
    const QPointF from = view.toPixel(ends[0]);
    const QPointF to = view.toPixel(ends[1]);
    drawLine(painter, from, to, planeColour());
    const QPointF hidden(
        glm::dot(plane.normalLps, slice.rightLps), glm::dot(plane.normalLps, slice.downLps));
    const double length = std::hypot(hidden.x(), hidden.y());
    for (const double along : {0.1, 0.5, 0.9}) {
        const QPointF at = from + (to - from) * along;
        if (length > 1e-6)
            drawLine(painter, at, at + hidden * (7.0 / length), planeColour());
    }
}

} // namespace

QPolygonF toPixels(const std::vector<glm::dvec3>& polygonLps, const ViewContext& view)
{
    QPolygonF polygon;
    for (const glm::dvec3& corner : polygonLps)
        polygon.push_back(view.toPixel(corner));
    return polygon;
}

void paintClipSection(QPainter& painter, const ViewContext& view, const core::ClipRegion& clip,
    const core::VolumeGeometry& geometry)
{
    painter.save();
    painter.setBrush(Qt::NoBrush);
    if (clip.box.on)
        paintBoxSection(painter, view, clip.box, geometry, boxColour());
    for (const core::ClipPlane& plane : clip.planes) {
        if (plane.on)
            paintPlaneLine(painter, view, plane, geometry);
    }
    painter.restore();
}

void paintBoxSection(QPainter& painter, const ViewContext& view, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry, const QColor& colour)
{
    const auto& slice = std::get<gpu::SliceScene>(view.scene);
    const auto section =
        core::boxSection(box, geometry, slice.centreLps, glm::cross(slice.rightLps, slice.downLps));
    drawPolygon(painter, toPixels(section, view), colour);
}

void paintClipBox(QPainter& painter, const ViewContext& view, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry)
{
    paintBox(painter, view, box, geometry, boxColour());
}

void paintBox(QPainter& painter, const ViewContext& view, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry, const QColor& colour)
{
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    const glm::dvec3 towardsViewer = scene.eyeLps - scene.targetLps;
    // A face is turned to the viewer where its outward normal, a gradient of its index, is.
    const glm::dmat3 gradients = glm::transpose(glm::dmat3(geometry.worldToIndex()));
    glm::dvec3 facing(0.0);
    for (int axis = 0; axis < 3; ++axis)
        facing[axis] = glm::dot(gradients[axis], towardsViewer);
    painter.save();
    for (int axis = 0; axis < 3; ++axis) {
        const int other = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        for (int edge = 0; edge < 4; ++edge) {
            const bool high = (edge & 1) != 0;
            const bool far = (edge & 2) != 0;
            glm::dvec3 from = box.minimum;
            from[other] = high ? box.maximum[other] : box.minimum[other];
            from[third] = far ? box.maximum[third] : box.minimum[third];
            glm::dvec3 to = from;
            to[axis] = box.maximum[axis];
            const bool front = (high ? facing[other] : -facing[other]) > 0.0
                || (far ? facing[third] : -facing[third]) > 0.0;
            QColor shade = colour;
            shade.setAlpha(front ? 230 : 80);
            drawLine(painter, view.toPixel(geometry.toWorld(from)),
                view.toPixel(geometry.toWorld(to)), shade);
        }
    }
    painter.restore();
}

void paintClipPlanes(QPainter& painter, const ViewContext& view, const core::ClipRegion& clip,
    const core::VolumeGeometry& geometry)
{
    painter.save();
    for (const core::ClipPlane& plane : clip.planes) {
        if (!plane.on)
            continue;
        const auto section = core::boxSection(
            core::wholeVolume(geometry).box, geometry, plane.pointLps, plane.normalLps);
        drawPolygon(painter, toPixels(section, view), planeColour());
    }
    painter.restore();
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/OrientationCube.h"

#include "ui/base/Theme.h"
#include "ui/geometry/OrientationLetters.h"

#include <QPainter>
#include <QPolygonF>

#include <array>
#include <cmath>

namespace ui {

namespace {

const std::array<glm::dvec3, 6> sides{glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0),
    glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)};

} // namespace

/// A face that can be seen, as a parallelogram in pixels.
struct OrientationCube::Face {
    QPointF centre;
    QPointF right; ///< half an edge, towards the letter's right
    QPointF down;
    double facing = 0.0; ///< 1: straight at the viewer

    [[nodiscard]] QPolygonF outline() const
    {
        return QPolygonF({centre - right - down, centre + right - down, centre + right + down,
            centre - right + down});
    }
};

OrientationCube::OrientationCube(const Camera& camera, const QPointF& centre, double edge)
    : m_right(camera.right())
    , m_up(camera.up)
    , m_towardsViewer(camera.towardsViewer)
    , m_centre(centre)
    , m_edge(edge)
{
}

std::optional<OrientationCube::Face> OrientationCube::faceTowards(const glm::dvec3& side) const
{
    const double facing = glm::dot(side, m_towardsViewer);
    if (facing < 0.02)
        return std::nullopt;
    // Letters stand upright on the sides of the body and face the front on its ends.
    const glm::dvec3 up =
        std::abs(side.z) > 0.5 ? glm::dvec3(0.0, -1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 right = glm::cross(up, side);
    const auto projected = [this](const glm::dvec3& vector) {
        return QPointF(glm::dot(vector, m_right), -glm::dot(vector, m_up)) * (m_edge / 2.0);
    };
    return Face{m_centre + projected(side), projected(right), projected(-up), facing};
}

void OrientationCube::paint(QPainter& painter) const
{
    painter.save();
    QFont font = theme::bodyFont();
    font.setWeight(QFont::Bold);
    painter.setFont(font);
    for (const glm::dvec3& side : sides) {
        const auto face = faceTowards(side);
        if (!face)
            continue;
        const int light = int(26 + 34 * face->facing);
        painter.setBrush(QColor(light, light + 4, light + 11, 235));
        painter.setPen(QPen(theme::line.lighter(140), 1.0));
        painter.drawPolygon(face->outline());
        painter.save();
        const double half = m_edge / 2.0;
        painter.setTransform(
            QTransform(face->right.x() / half, face->right.y() / half, face->down.x() / half,
                face->down.y() / half, face->centre.x(), face->centre.y()),
            true);
        QColor colour = theme::text;
        colour.setAlphaF(float(std::min(1.0, 0.25 + face->facing)));
        painter.setPen(colour);
        painter.drawText(
            QRectF(-half, -half, m_edge, m_edge), Qt::AlignCenter, directionLetters(side));
        painter.restore();
    }
    painter.restore();
}

std::optional<glm::dvec3> OrientationCube::sideAt(const QPointF& pixel) const
{
    for (const glm::dvec3& side : sides) {
        const auto face = faceTowards(side);
        if (face && face->outline().containsPoint(pixel, Qt::OddEvenFill))
            return side;
    }
    return std::nullopt;
}

} // namespace ui

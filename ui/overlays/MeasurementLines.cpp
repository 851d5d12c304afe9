// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/MeasurementLines.h"

#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Whether a place lies in a slice, as far as its voxels can tell.
bool liesIn(const gpu::SliceScene& slice, const glm::dvec3& lps, const glm::dvec3& spacingMm)
{
    const glm::dvec3 normal = glm::cross(slice.rightLps, slice.downLps);
    const double reach = std::max({spacingMm.x, spacingMm.y, spacingMm.z}) / 2.0;
    return std::abs(glm::dot(lps - slice.centreLps, normal)) <= reach;
}

} // namespace

QString lengthText(double mm)
{
    return QObject::tr("%1 mm").arg(numberText(mm, 1));
}

void paintMeasurement(
    QPainter& painter, const ViewContext& view, const QPointF& from, const QPointF& to, double mm)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF along = to - from;
    const double length = std::hypot(along.x(), along.y());
    const QPointF across =
        length > 0.0 ? QPointF(-along.y(), along.x()) * (5.0 / length) : QPointF(0, 5);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 170), 3.6), QPen(theme::accent, 1.4)}) {
        painter.setPen(pen);
        painter.drawLine(from, to);
        painter.drawLine(from - across, from + across);
        painter.drawLine(to - across, to + across);
    }
    painter.setFont(theme::smallFont());
    const QFontMetricsF metrics(painter.font());
    const QString text = lengthText(mm);
    QRectF box(QPointF(0, 0), QSizeF(metrics.horizontalAdvance(text) + 10, metrics.height() + 4));
    // Beside the middle, on the side that looks up.
    QPointF side = across.y() > 0.0 ? -across : across;
    side *= (box.height() / 2.0 + 0.5 * box.width() * std::abs(side.x()) / 5.0 + 4.0) / 5.0;
    box.moveCenter((from + to) / 2.0 + side);
    const QRectF room(QPointF(2, 2), view.sizePixels - QSizeF(4, 4));
    box.moveLeft(
        std::clamp(box.left(), room.left(), std::max(room.left(), room.right() - box.width())));
    box.moveTop(
        std::clamp(box.top(), room.top(), std::max(room.top(), room.bottom() - box.height())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(theme::text);
    painter.drawText(box, Qt::AlignCenter, text);
    painter.restore();
}

void paintMeasurements(QPainter& painter, const ViewContext& view, const Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    if (!session || !workspace.volume())
        return;
    const core::Document& document = session->document();
    const core::VolumeGeometry& geometry = workspace.volume()->geometry;
    for (const core::Measurement& measured : document.measurements) {
        glm::dvec3 from = measured.fromLps;
        glm::dvec3 to = measured.toLps;
        if (const auto* slice = std::get_if<gpu::SliceScene>(&view.scene)) {
            if (!liesIn(*slice, from, geometry.spacingMm())
                || !liesIn(*slice, to, geometry.spacingMm()))
                continue;
        } else if (const core::Piece* piece = document.piece(measured.piece)) {
            if (!workspace.pieces().look(piece->id).visible)
                continue;
            core::Piece shown = *piece;
            shown.pose = workspace.pieces().pose(*piece);
            const glm::dmat4 pose = core::shownFromTrue(shown, geometry);
            from = glm::dvec3(pose * glm::dvec4(from, 1.0));
            to = glm::dvec3(pose * glm::dvec4(to, 1.0));
        }
        paintMeasurement(painter, view, view.toPixel(from), view.toPixel(to), measured.lengthMm());
    }
}

} // namespace ui

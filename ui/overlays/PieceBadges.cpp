// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/PieceBadges.h"

#include "ui/base/Theme.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <algorithm>

namespace ui {

void paintPieceBadges(QPainter& painter, const ViewContext& view, const Workspace& workspace)
{
    if (!workspace.volume() || view.isSlice())
        return;
    const Pieces& pieces = workspace.pieces();
    painter.save();
    painter.setFont(theme::smallFont());
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(painter.font());
    for (const core::Piece& piece : workspace.session()->document().pieces) {
        const core::PiecePose pose = pieces.pose(piece);
        if (!pieces.look(piece.id).visible || pose.isHome())
            continue;
        const QPointF at =
            view.toPixel(core::pivotOf(piece, workspace.volume()->geometry) + pose.offsetMm);
        const QString text = piece.name + QStringLiteral("  ") + Pieces::badge(pose);
        QRectF box(
            QPointF(0, 0), QSizeF(metrics.horizontalAdvance(text) + 14, metrics.height() + 6));
        box.moveCenter(at + QPointF(0, 70));
        const QRectF room(QPointF(4, 4), view.sizePixels - QSizeF(8, 8));
        box.moveLeft(
            std::clamp(box.left(), room.left(), std::max(room.left(), room.right() - box.width())));
        box.moveTop(
            std::clamp(box.top(), room.top(), std::max(room.top(), room.bottom() - box.height())));
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 170));
        painter.drawRoundedRect(box, 4, 4);
        painter.setPen(piece.id == pieces.active() ? theme::accent : theme::text);
        painter.drawText(box, Qt::AlignCenter, text);
    }
    painter.restore();
}

} // namespace ui

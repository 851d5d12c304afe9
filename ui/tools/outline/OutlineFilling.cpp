// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/outline/OutlineFilling.h"

#include "core/edits/kinds/segments/FillOutline.h"
#include "core/sculpt/labels/LabelOutlined.h"
#include "core/session/EditSession.h"
#include "ui/tools/aim/DrillMask.h"
#include "ui/tools/common/SliceOutline.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QColor>
#include <QCoreApplication>
#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

struct OutlineFilling {
    Q_DECLARE_TR_FUNCTIONS(ui::OutlineFilling)
};

QColor fillingColour(const Workspace& workspace)
{
    const core::Document& document = workspace.session()->document();
    const core::Segment* segment = document.segment(workspace.activeSegment());
    return segment ? QColor(segment->rgb) : QColor(nextSegmentColour(document));
}

} // namespace

bool fillOutline(Workspace& workspace, const SliceOutline& outline, bool erases)
{
    core::FillOutline edit{.segment = 0,
        .originLps = outline.originLps(),
        .rightLps = outline.rightLps(),
        .upLps = outline.upLps(),
        .polygonMm = outline.polygonMm(),
        .erase = erases};
    if (edit.polygonMm.size() > core::LabelOutlined::mostCorners) {
        workspace.say(OutlineFilling::tr("This outline has too many corners: take some back"));
        return false;
    }
    if (erases && workspace.session()->document().segments.empty()) {
        workspace.say(OutlineFilling::tr("There is no segment to erase"));
        return false;
    }
    const auto refused = [&workspace](const core::Error& error) {
        workspace.fail(error);
        return false;
    };
    const core::Result<int> label = ensureActiveSegment(workspace);
    if (!label)
        return refused(label.error());
    const Workspace::BrushSettings& limits = workspace.brushSettings(Workspace::Brush::Paint);
    edit.segment = *label;
    edit.overwriteUnlocked = limits.overwriteUnlocked && !edit.erase;
    if (limits.onlyBetween) {
        edit.lower = std::min(limits.lower, limits.upper);
        edit.upper = std::max(limits.lower, limits.upper);
    }
    edit.editable = workspace.editableRange();
    if (const auto applied = workspace.session()->apply(edit); !applied)
        return refused(applied.error());
    return true;
}

QString fillingText(const Workspace& workspace, bool erases)
{
    const core::EditSession* session = workspace.session();
    if (!session)
        return {};
    const core::Segment* segment = session->document().segment(workspace.activeSegment());
    if (!segment)
        return erases ? OutlineFilling::tr("no segment to erase")
                      : OutlineFilling::tr("fills a new segment");
    if (segment->locked)
        return OutlineFilling::tr("%1 is locked").arg(segment->name);
    return (erases ? OutlineFilling::tr("erases %1") : OutlineFilling::tr("fills %1"))
        .arg(segment->name);
}

void paintFilling(QPainter& painter, const Workspace& workspace, const QPolygonF& outline,
    bool erases, bool isClosed)
{
    QColor tint = fillingColour(workspace);
    tint.setAlpha(70);
    painter.setPen(Qt::NoPen);
    painter.setBrush(erases ? QBrush(tint, Qt::BDiagPattern) : QBrush(tint));
    painter.drawPolygon(outline, Qt::WindingFill);
    painter.setBrush(Qt::NoBrush);
    drawToolOutline(painter, outline, isClosed);
}

} // namespace ui

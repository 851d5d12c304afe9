// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/PaintTool.h"

#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/session/past/SeedStrokes.h"
#include "ui/tools/common/BrushOptions.h"
#include "ui/tools/common/EdgeOptions.h"
#include "ui/tools/common/PaintLimits.h"
#include "ui/workspace/SegmentActions.h"

#include <algorithm>

namespace ui {

PaintTool::PaintTool(Workspace& workspace, QObject* parent)
    : BrushTool(workspace, Workspace::Brush::Paint, parent)
{
}

void PaintTool::setErases(bool erases)
{
    if (erases == m_erases)
        return;
    m_erases = erases;
    Q_EMIT nameChanged();
    Q_EMIT overlayChanged();
}

bool PaintTool::endMode()
{
    const bool erased = m_erases;
    setErases(false);
    return erased;
}

QString PaintTool::name() const
{
    return m_erases ? tr("Erase") : tr("Paint");
}

QString PaintTool::iconName() const
{
    return QStringLiteral("paint");
}

QString PaintTool::hint() const
{
    return m_erases ? tr("Erase: draw on a slice or on the 3D view; Ctrl or the eraser end paints")
                    : tr("Paint: draw on a slice or on the 3D view; Ctrl or the eraser end erases");
}

QString PaintTool::keys() const
{
    return m_erases ? tr("[ ] radius · Ctrl paints · Esc cancels")
                    : tr("[ ] radius · Ctrl erases · Esc cancels");
}

QWidget* PaintTool::createOptions(QWidget* parent)
{
    return new BrushOptions(workspace(), Workspace::Brush::Paint, parent);
}

QString PaintTool::action(bool inverted) const
{
    const core::EditSession* session = workspace().session();
    if (!session)
        return {};
    const core::Segment* segment = session->document().segment(workspace().activeSegment());
    if (!segment)
        return inverted ? tr("no segment to erase") : tr("paints a new segment");
    if (segment->locked)
        return tr("%1 is locked").arg(segment->name);
    return (inverted ? tr("erases %1") : tr("paints %1")).arg(segment->name);
}

QString PaintTool::whyNot(bool inverted) const
{
    const bool isEmpty = workspace().session()->foreseenDocument().segments.empty();
    return inverted && isEmpty ? tr("There is no segment to erase") : QString();
}

QString PaintTool::limits() const
{
    return limitsText(workspace());
}

QString PaintTool::edges() const
{
    return edgesText(workspace());
}

QColor PaintTool::colour() const
{
    const core::EditSession* session = workspace().session();
    if (!session)
        return {};
    const core::Segment* segment = session->document().segment(workspace().activeSegment());
    return segment ? QColor(segment->rgb) : QColor(nextSegmentColour(session->document()));
}

BrushTool::StrokeMaker PaintTool::strokeMaker(bool inverted, const ViewContext& view)
{
    const Workspace::BrushSettings& now = settings();
    core::PaintStroke stroke;
    stroke.segment = activateSegment(workspace());
    stroke.erase = inverted;
    stroke.overwriteUnlocked = now.overwriteUnlocked && !inverted;
    if (now.onlyBetween) {
        stroke.lower = std::min(now.lower, now.upper);
        stroke.upper = std::max(now.lower, now.upper);
    }
    const bool followsEdges = now.followsEdges && view.isSlice();
    if (followsEdges)
        stroke.edgeTolerance = now.edgeTolerance;
    stroke.editable = workspace().editableRange();
    return [&shared = workspace(), stroke, byPressure = followsEdges && now.toleranceByPressure,
               choice = workspace().editableSettings(), box = workspace().editableBox()](
               const core::BrushPath& path) -> core::Result<core::Edit> {
        core::PaintStroke made = stroke;
        // A segment is made only for a stroke that meets something.
        if (made.segment == 0) {
            const core::Result<int> label = ensureActiveSegment(shared);
            if (!label)
                return tl::unexpected(label.error());
            made.segment = *label;
            // The choice is that of pen-down; whether the new segment is seen is known only now.
            made.editable = editableRange(choice, shared.session()->foreseenDocument(), box);
        }
        made.path = path;
        made.seeds = !made.erase && takesPartInGrowth(shared.session()->history(), made.segment);
        if (byPressure && path.pressures)
            made.toleranceByPressure = true;
        return core::Edit(made);
    };
}

bool takesPartInGrowth(const core::History& history, int segment)
{
    const std::vector<core::RowId> rows = history.standing();
    return std::any_of(rows.begin(), rows.end(),
        [&](core::RowId row) { return core::segmentOfSeeds(history.row(row).edit) == segment; });
}

} // namespace ui

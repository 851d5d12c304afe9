// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/ToolMaskDrawing.h"

#include "ui/base/NumberText.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/DrillMask.h"
#include "ui/tools/sculpt/DrillOptions.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr double tolerancePixels = 0.35;

} // namespace

ToolMaskDrawing::ToolMaskDrawing(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::drillSettingsChanged, this, &ToolMaskDrawing::follow);
}

bool ToolMaskDrawing::isWanted() const
{
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    return settings.freehand && (m_asked || settings.outline.empty());
}

void ToolMaskDrawing::want(bool wanted)
{
    if (!wanted) {
        cancel();
        return;
    }
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    settings.freehand = true;
    m_asked = true;
    m_workspace.setDrillSettings(settings);
    follow();
    m_workspace.say(hint());
}

/// Another shape was chosen, or the outline came with a preset.
void ToolMaskDrawing::follow()
{
    if (!m_workspace.drillSettings().freehand) {
        m_asked = false;
        m_sketch.drop();
    }
    if (isWanted() == m_wasWanted)
        return;
    m_wasWanted = isWanted();
    Q_EMIT changed();
}

QString ToolMaskDrawing::hint() const
{
    return tr("Draw the mask's outline on the 3D view; it closes by itself, Esc cancels");
}

void ToolMaskDrawing::press(const PointerSample& sample, const ViewContext& view)
{
    m_pen = sample;
    m_sketch.begin(sample.position, view);
}

void ToolMaskDrawing::drag(const PointerSample& sample, const ViewContext& view)
{
    if (view.view == m_sketch.view().view)
        m_sketch.extend(sample.position);
}

void ToolMaskDrawing::release(const PointerSample& sample, const ViewContext& view)
{
    drag(sample, view);
    const double mmPerPixel = m_sketch.view().mmPerPixel();
    take(m_sketch.finish(), mmPerPixel);
}

void ToolMaskDrawing::take(const std::vector<glm::dvec2>& curveMm, double mmPerPixel)
{
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    // What was drawn is what a pen held like this is to press.
    settings.rotationDegrees = 0.0;
    const std::optional<DrawnToolMask> drawn =
        drawnToolMask(withoutPen(curveMm, settings, m_pen), tolerancePixels * mmPerPixel);
    if (!drawn) {
        m_workspace.say(tr("That is too small for a mask: draw a curve around what it is to "
                           "cover"));
        return;
    }
    settings.freehand = true;
    settings.outline = drawn->outline;
    settings.radiusMm =
        std::clamp(drawn->radiusMm, DrillOptions::minimumRadiusMm, DrillOptions::maximumRadiusMm);
    m_asked = false;
    m_workspace.setDrillSettings(settings);
    follow();
    const QString across = numberText(2.0 * settings.radiusMm, 1);
    if (settings.radiusMm < drawn->radiusMm)
        m_workspace.say(
            tr("The outline is the mask now, made smaller: %1 mm across is the most").arg(across));
    else
        m_workspace.say(tr("The outline is the mask now, %1 mm across").arg(across));
}

bool ToolMaskDrawing::cancel()
{
    if (!isWanted())
        return false;
    m_sketch.drop();
    m_asked = false;
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    settings.freehand = !settings.outline.empty();
    m_workspace.setDrillSettings(settings);
    follow();
    m_workspace.say(tr("No outline was drawn; the mask is as it was"));
    return true;
}

void ToolMaskDrawing::drop()
{
    m_sketch.drop();
}

void ToolMaskDrawing::paint(QPainter& painter, const ViewContext& view, const QPointF& cursor) const
{
    if (m_sketch.drawing())
        m_sketch.paint(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(cursor, 2.0, 2.0);
    drawCursorLabel(painter, view.sizePixels, cursor, 6.0,
        {tr("draw the mask's outline"), tr("closes by itself · Esc cancels")});
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/OutlineTool.h"

#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/DrillMask.h"
#include "ui/tools/aim/DrillSurface.h"
#include "ui/tools/aim/PickQuestion.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/Workspace.h"

#include <QPainter>

#include <utility>

namespace ui {

namespace {

constexpr double hoverMm = 6.0;
constexpr int hoverAcross = 12; ///< rays
constexpr int sketchAcross = 32;

} // namespace

OutlineTool::OutlineTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
    , m_preview(workspace, [this] { Q_EMIT overlayChanged(); })
{
    connect(&workspace, &Workspace::activeLayerChanged, this, &Tool::overlayChanged);
    // A curve ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_sketch.drop();
        m_pressure.end();
        m_preview.forget();
    });
}

QString OutlineTool::target() const
{
    return carvingTarget(m_workspace, m_restores);
}

bool OutlineTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return scene && scene->orthographic && scene->context != gpu::Context::Hidden
        && scene->context != gpu::Context::CutAway;
}

double OutlineTool::surfaceThreshold() const
{
    return drillThreshold(m_workspace.volumeDisplay(), *m_workspace.volume());
}

void OutlineTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !worksIn(view) || m_sketch.drawing())
        return;
    begin();
    m_sketch.begin(sample.position, view);
    m_pressure.begin(sample, depthFollowsPressure());
    m_restores = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    showCursor(sample.position, view.view);
}

void OutlineTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_sketch.drawing() || view.view != m_sketch.view().view)
        return;
    m_sketch.extend(sample.position);
    m_pressure.extend(sample);
    if (showsTaken()) {
        if (std::vector<glm::dvec2> outline = m_sketch.curveMm(); outline.size() >= 3)
            m_preview.lookAt(m_sketch.view(), std::move(outline), sketchAcross);
    }
    showCursor(sample.position, view.view);
}

void OutlineTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_sketch.drawing())
        return;
    drag(sample, view);
    const ViewContext sketched = m_sketch.view();
    std::vector<glm::dvec2> curve = m_sketch.finish();
    m_preview.forget();
    if (curve.empty()) {
        m_workspace.say(tr("Draw a curve around what is to be cut; it closes by itself"));
    } else {
        Sketch sketch;
        const auto& scene = std::get<gpu::VolumeScene>(sketched.scene);
        sketch.view = orthographicView(scene);
        sketch.hidden = core::clipHalfSpaces(scene.clip, m_workspace.volume()->geometry);
        sketch.restore = m_restores;
        sketch.polygonMm = std::move(curve);
        cut(sketch);
    }
    m_pressure.end();
    showCursor(sample.position, view.view);
}

void OutlineTool::cancel()
{
    m_sketch.drop();
    m_pressure.end();
    m_preview.forget();
    Q_EMIT overlayChanged();
}

void OutlineTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_restores = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    if (showsTaken() && worksIn(view) && m_workspace.session()) {
        // A little of it: which surface a curve here would take.
        const glm::dvec2 middle = view.toViewPlaneMm(sample.position);
        std::vector<glm::dvec2> outline = core::outlineMm({.radiusMm = hoverMm}, view.mmPerPixel());
        for (glm::dvec2& point : outline)
            point += middle;
        m_preview.lookAt(view, std::move(outline), hoverAcross);
    }
    showCursor(sample.position, view.view);
}

void OutlineTool::leave()
{
    m_preview.forget();
    CursorTool::leave();
}

void OutlineTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !isUnderPointer(view) || !worksIn(view))
        return;
    if (const SurfacePatch* surface = m_preview.patch())
        paintPatch(painter, taken(*surface), view);
    if (m_sketch.drawing())
        m_sketch.paint(painter);
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(cursor(), 2.0, 2.0);
    drawCursorLabel(painter, view.sizePixels, cursor(), 6.0, lines() << target());
}

} // namespace ui

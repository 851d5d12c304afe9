// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/OutlineTool.h"

#include "core/edits/HiddenSides.h"
#include "core/edits/ToolMasks.h"
#include "ui/LayerActions.h"
#include "ui/Workspace.h"
#include "ui/tools/CursorLabel.h"
#include "ui/tools/DrillMask.h"
#include "ui/tools/DrillSurface.h"
#include "ui/tools/PickQuestion.h"

#include <QPainter>

namespace ui {

namespace {

constexpr double leastStepPixels = 1.5;
constexpr double leastSidePixels = 4.0;
constexpr double hoverMm = 6.0;
constexpr int hoverAcross = 12; ///< rays
constexpr int sketchAcross = 32;

} // namespace

OutlineTool::OutlineTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
    , m_preview(workspace, [this] { Q_EMIT overlayChanged(); })
{
    connect(&workspace, &Workspace::activeLayerChanged, this, &Tool::overlayChanged);
    // A curve ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_sketchView.reset();
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
    return scene && scene->orthographic;
}

double OutlineTool::surfaceThreshold() const
{
    return drillThreshold(m_workspace.volumeDisplay(), *m_workspace.volume());
}

void OutlineTool::press(const PointerSample& sample, const ViewContext& view)
{
    if (!m_workspace.session() || !worksIn(view) || m_sketchView)
        return;
    begin();
    m_sketchView = view;
    m_sketch = QPolygonF({sample.position});
    m_restores = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    showCursor(sample, view.view);
}

void OutlineTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_sketchView || view.view != m_sketchView->view)
        return;
    const QPointF step = sample.position - m_sketch.back();
    if (QPointF::dotProduct(step, step) >= leastStepPixels * leastStepPixels)
        m_sketch << sample.position;
    if (showsTaken() && m_sketch.size() >= 3) {
        std::vector<glm::dvec2> outline;
        for (const QPointF& point : m_sketch)
            outline.push_back(m_sketchView->toViewPlaneMm(point));
        m_preview.lookAt(*m_sketchView, std::move(outline), sketchAcross);
    }
    showCursor(sample, view.view);
}

void OutlineTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_sketchView)
        return;
    drag(sample, view);
    const ViewContext sketched = *m_sketchView;
    m_sketchView.reset();
    m_preview.forget();
    const QRectF box = m_sketch.boundingRect();
    if (m_sketch.size() < 3 || box.width() < leastSidePixels || box.height() < leastSidePixels) {
        m_workspace.say(tr("Draw a curve around what is to be cut; it closes by itself"));
    } else {
        Sketch sketch;
        const auto& scene = std::get<gpu::VolumeScene>(sketched.scene);
        sketch.view = orthographicView(scene);
        sketch.hidden = core::hiddenSides(scene.clip, m_workspace.volume()->geometry);
        sketch.restore = m_restores;
        for (const QPointF& point : m_sketch)
            sketch.polygonMm.push_back(sketched.toViewPlaneMm(point));
        cut(sketch);
    }
    showCursor(sample, view.view);
}

void OutlineTool::cancel()
{
    m_sketchView.reset();
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
    showCursor(sample, view.view);
}

void OutlineTool::leave()
{
    m_preview.forget();
    m_cursorView.reset();
    Q_EMIT overlayChanged();
}

void OutlineTool::showCursor(const PointerSample& sample, gpu::ViewId view)
{
    m_cursor = sample.position;
    m_cursorView = view;
    Q_EMIT overlayChanged();
}

void OutlineTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || m_cursorView != view.view || !worksIn(view))
        return;
    if (const SurfacePatch* surface = m_preview.patch())
        paintPatch(painter, taken(*surface), view);
    if (m_sketchView) {
        // Where it closes by itself, a thin line says so.
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(toolColour(), 1.0, Qt::DotLine));
        painter.drawLine(m_sketch.back(), m_sketch.front());
        drawToolOutline(painter, m_sketch, false);
    }
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(m_cursor, 2.0, 2.0);
    drawCursorLabel(painter, view.sizePixels, m_cursor, 6.0, lines() << target());
}

} // namespace ui

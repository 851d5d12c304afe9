// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/DrillTool.h"

#include "ui/Workspace.h"
#include "ui/tools/CursorLabel.h"
#include "ui/tools/DrillOptions.h"
#include "ui/tools/DrillSurface.h"
#include "ui/tools/PickQuestion.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// What lies so much deeper than the cut is seen through a gap.
constexpr double guardMm = 5.0;

/// The next round millimetre value: steps grow with the size, a tenth of it at least half a mm.
double stepped(double value, int steps, double minimum, double maximum)
{
    const double step = value < 10.0 ? 0.5 : value < 30.0 ? 1.0 : 2.0;
    return std::clamp(std::round((value + steps * step) / step) * step, minimum, maximum);
}

} // namespace

DrillTool::DrillTool(Workspace& workspace, QObject* parent)
    : Tool(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::drillSettingsChanged, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::activeLayerChanged, this, &Tool::overlayChanged);
    // A stroke ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionChanged, this, [this] { m_strokeView.reset(); });
}

QString DrillTool::name() const
{
    return tr("Drill");
}

QString DrillTool::iconName() const
{
    return QStringLiteral("drill");
}

QString DrillTool::hint() const
{
    return tr("Drill: press on the surface in the 3D view; pressure sets the depth");
}

QString DrillTool::target() const
{
    const core::EditSession* session = m_workspace.session();
    const core::SculptLayer* layer =
        session ? session->document().layer(m_workspace.activeLayer()) : nullptr;
    if (!layer)
        return {};
    return layer->muted ? tr("layer %1 is muted").arg(layer->name)
                        : tr("carves layer %1").arg(layer->name);
}

QString DrillTool::keys() const
{
    return tr("[ ] radius · Alt+wheel depth · Esc cancels");
}

QWidget* DrillTool::createOptions(QWidget* parent)
{
    return new DrillOptions(m_workspace, parent);
}

bool DrillTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return scene && scene->orthographic;
}

core::DrillStroke DrillTool::strokeIn(const ViewContext& view) const
{
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    core::DrillStroke stroke;
    stroke.layer = m_workspace.activeLayer();
    stroke.view = orthographicView(scene);
    stroke.mask.radiusMm = settings.radiusMm;
    stroke.depthMm = settings.depthMm;
    stroke.throughGaps = settings.throughGaps;
    stroke.guardMm = guardMm;
    stroke.byTime = true;
    stroke.surfaceThreshold = drillThreshold(m_workspace.volumeDisplay(), *m_workspace.volume());
    return stroke;
}

core::PenSample DrillTool::penSample(const PointerSample& sample) const
{
    const glm::dvec2 mm = m_strokeView->toViewPlaneMm(sample.position);
    return {mm.x, mm.y, sample.pressure, sample.timeSeconds - m_startSeconds};
}

void DrillTool::press(const PointerSample& sample, const ViewContext& view)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !worksIn(view) || m_strokeView)
        return;
    if (sample.eraserEnd) {
        m_workspace.say(tr("The drill has no use for the eraser end; turn the pen"));
        return;
    }
    if (const auto begun = session->begin(strokeIn(view)); !begun) {
        m_workspace.fail(begun.error());
        return;
    }
    m_strokeView = view;
    m_startSeconds = sample.timeSeconds;
    session->extendDrill({penSample(sample)});
    showCursor(sample, view.view);
}

void DrillTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_strokeView || view.view != m_strokeView->view)
        return;
    m_workspace.session()->extendDrill({penSample(sample)});
    showCursor(sample, view.view);
}

void DrillTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_strokeView)
        return;
    m_strokeView.reset();
    m_workspace.session()->end(core::Ending::Commit);
    showCursor(sample, view.view);
}

void DrillTool::cancel()
{
    if (!m_strokeView)
        return;
    m_strokeView.reset();
    if (core::EditSession* session = m_workspace.session())
        session->end(core::Ending::Rollback);
    m_workspace.say(tr("The stroke was taken back"));
    Q_EMIT overlayChanged();
}

void DrillTool::hover(const PointerSample& sample, const ViewContext& view)
{
    showCursor(sample, view.view);
}

void DrillTool::leave()
{
    m_cursorView.reset();
    Q_EMIT overlayChanged();
}

void DrillTool::showCursor(const PointerSample& sample, gpu::ViewId view)
{
    m_cursor = sample.position;
    m_cursorView = view;
    m_pressure = m_strokeView ? sample.pressure : 0.0;
    Q_EMIT overlayChanged();
}

void DrillTool::changeRadius(int steps)
{
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    settings.radiusMm = stepped(
        settings.radiusMm, steps, DrillOptions::minimumRadiusMm, DrillOptions::maximumRadiusMm);
    m_workspace.setDrillSettings(settings);
}

void DrillTool::changeDepth(int steps)
{
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    settings.depthMm = stepped(
        settings.depthMm, steps, DrillOptions::minimumDepthMm, DrillOptions::maximumDepthMm);
    m_workspace.setDrillSettings(settings);
}

void DrillTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || m_cursorView != view.view || !worksIn(view))
        return;
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    const double radius = settings.radiusMm / view.mmPerPixel();

    // A dark rim under the bright line keeps the outline visible on bone and on black alike.
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3.5));
    painter.drawEllipse(m_cursor, radius, radius);
    painter.setPen(QPen(toolColour(), 1.6));
    painter.drawEllipse(m_cursor, radius, radius);
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(m_cursor, 2.0, 2.0);

    const QString full = QLocale().toString(settings.depthMm, 'f', 1);
    QString depth = tr("%1 mm deep").arg(full);
    if (m_strokeView) {
        // Mode Limit: the depth grows with the square of the pressure (DrillStroke's exponent).
        const double now = settings.depthMm * m_pressure * m_pressure;
        depth = tr("%1 of %2 mm").arg(QLocale().toString(now, 'f', 1), full);
    }
    const QString size = tr("radius %1 mm").arg(QLocale().toString(settings.radiusMm, 'f', 1));
    QStringList lines{depth, size, target()};
    // Where the picture itself does not say where a cut starts.
    if (m_workspace.volumeDisplay().mode != gpu::RenderMode::Surface)
        lines += startText(m_workspace);
    drawCursorLabel(painter, view.sizePixels, m_cursor, radius, lines);
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/DrillTool.h"

#include "core/edits/HiddenSides.h"
#include "ui/tools/CursorLabel.h"
#include "ui/tools/DrillMask.h"
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

bool restoresWith(const PointerSample& sample)
{
    return sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
}

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
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_strokeView.reset();
        m_resting.stop();
    });
    m_resting.setInterval(16);
    connect(&m_resting, &QTimer::timeout, this, &DrillTool::rest);
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
    return tr("Drill: press on the surface; pressure sets the depth, Ctrl or the eraser end "
              "restores");
}

QString DrillTool::target() const
{
    const core::EditSession* session = m_workspace.session();
    const core::SculptLayer* layer =
        session ? session->document().layer(m_workspace.activeLayer()) : nullptr;
    if (!layer)
        return {};
    if (layer->muted)
        return tr("layer %1 is muted").arg(layer->name);
    if (!session->document().carves(*layer))
        return tr("layer %1 is left out").arg(layer->name);
    return (m_restores ? tr("restores layer %1") : tr("carves layer %1")).arg(layer->name);
}

QString DrillTool::keys() const
{
    return tr("[ ] radius · Alt+wheel depth · Ctrl restores · Esc cancels");
}

QWidget* DrillTool::createOptions(QWidget* parent)
{
    return new DrillOptions(m_workspace, DrillOptions::Of::Drill, parent);
}

bool DrillTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return scene && scene->orthographic;
}

core::DrillStroke DrillTool::strokeIn(const ViewContext& view, bool restore) const
{
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    core::DrillStroke stroke;
    stroke.layer = m_workspace.activeLayer();
    stroke.view = orthographicView(scene);
    stroke.mask = drillMask(settings);
    stroke.mode = settings.mode;
    stroke.floorMm = settings.floorMm;
    stroke.pressureExponent = settings.pressureExponent;
    stroke.restore = restore;
    stroke.depthMm = settings.depthMm;
    stroke.throughGaps = settings.throughGaps;
    stroke.guardMm = guardMm;
    stroke.byTime = true;
    stroke.surfaceThreshold = drillThreshold(m_workspace.volumeDisplay(), *m_workspace.volume());
    stroke.hidden = core::hiddenSides(scene.clip, m_workspace.volume()->geometry);
    return stroke;
}

core::Edit DrillTool::editIn(const ViewContext& view, bool restore) const
{
    return strokeIn(view, restore);
}

double& DrillTool::depthIn(Workspace::DrillSettings& settings) const
{
    return settings.depthMm;
}

double DrillTool::depthMm() const
{
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    return depthIn(settings);
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
    m_restores = restoresWith(sample);
    if (const auto begun = session->begin(editIn(view, m_restores)); !begun) {
        m_workspace.fail(begun.error());
        return;
    }
    m_strokeView = view;
    m_startSeconds = sample.timeSeconds;
    tell(sample);
    if (m_workspace.drillSettings().mode == core::DrillMode::Rate)
        m_resting.start();
    showCursor(sample, view.view);
}

void DrillTool::tell(const PointerSample& sample)
{
    m_told = penSample(sample);
    m_sinceTold.start();
    m_workspace.session()->extendDrill({m_told});
}

/// A pen that does not move reports nothing, yet it goes on pressing.
void DrillTool::rest()
{
    core::PenSample now = m_told;
    now.tSeconds += double(m_sinceTold.elapsed()) / 1000.0;
    if (core::EditSession* session = m_workspace.session(); session && m_strokeView)
        session->extendDrill({now});
}

void DrillTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_strokeView || view.view != m_strokeView->view)
        return;
    tell(sample);
    showCursor(sample, view.view);
}

void DrillTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_strokeView)
        return;
    m_strokeView.reset();
    m_resting.stop();
    m_workspace.session()->end(core::Ending::Commit);
    showCursor(sample, view.view);
}

void DrillTool::cancel()
{
    if (!m_strokeView)
        return;
    m_strokeView.reset();
    m_resting.stop();
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
    if (!m_strokeView)
        m_restores = restoresWith(sample);
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
    depthIn(settings) =
        stepped(depthMm(), steps, DrillOptions::minimumDepthMm, DrillOptions::maximumDepthMm);
    m_workspace.setDrillSettings(settings);
}

void DrillTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || m_cursorView != view.view || !worksIn(view))
        return;
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    const double radius = settings.radiusMm / view.mmPerPixel();

    drawToolOutline(painter, maskOutline(drillMask(settings), m_cursor, view.mmPerPixel()));
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(m_cursor, 2.0, 2.0);

    const QString full = QLocale().toString(depthMm(), 'f', 1);
    const bool rate = settings.mode == core::DrillMode::Rate;
    QString depth = rate ? tr("%1 mm a second").arg(full) : tr("%1 mm deep").arg(full);
    if (m_strokeView && !rate) {
        // Mode Limit: the depth grows with the square of the pressure (DrillStroke's exponent).
        const double now = depthMm() * m_pressure * m_pressure;
        depth = tr("%1 of %2 mm").arg(QLocale().toString(now, 'f', 1), full);
    }
    const QString size = settings.shape == core::MaskShape::Kind::Circle
        ? tr("radius %1 mm").arg(QLocale().toString(settings.radiusMm, 'f', 1))
        : tr("width %1 mm").arg(QLocale().toString(2.0 * settings.radiusMm, 'f', 1));
    QStringList lines{depth, size, target()};
    // Where the picture itself does not say where a cut starts.
    if (m_workspace.volumeDisplay().mode != gpu::RenderMode::Surface)
        lines += startText(m_workspace);
    drawCursorLabel(painter, view.sizePixels, m_cursor, radius, lines);
}

} // namespace ui

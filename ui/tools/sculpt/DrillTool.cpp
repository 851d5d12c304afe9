// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/DrillTool.h"

#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/NumberText.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/DrillMask.h"
#include "ui/tools/aim/DrillSurface.h"
#include "ui/tools/aim/PickQuestion.h"
#include "ui/tools/aim/WaitingStroke.h"
#include "ui/tools/sculpt/DrillOptions.h"
#include "ui/workspace/LayerActions.h"

#include <QPainter>
#include <QPointer>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

/// What lies so much deeper than the cut is seen through a gap.
constexpr double guardMm = 5.0;
constexpr double turnDegrees = 5.0; ///< of a step of the wheel
constexpr int previewAcross = 14; ///< rays

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

/// A stroke that waits for the place it is to go in at.
struct DrillTool::Aiming {
    core::DrillStroke stroke; ///< in the view of pen-down, as all was set then
    Workspace::Sweep sweep = Workspace::Sweep::View;
    QPointF tiltDegrees; ///< of the pen when it went down
    std::vector<PointerSample> samples;
    bool released = false;
};

DrillTool::DrillTool(Workspace& workspace, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
    , m_drawing(workspace)
    , m_preview(workspace, [this] { Q_EMIT overlayChanged(); })
{
    connect(&workspace, &Workspace::drillSettingsChanged, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::activeLayerChanged, this, &Tool::overlayChanged);
    connect(&m_drawing, &ToolMaskDrawing::changed, this, [this] {
        m_preview.forget();
        Q_EMIT overlayChanged();
    });
    // A stroke ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_drawing.drop();
        m_strokeView.reset();
        m_aiming.reset();
        m_resting.stop();
        m_preview.forget();
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
    if (m_drawing.isWanted())
        return m_drawing.hint();
    return tr("Drill: press on the surface; pressure sets the depth, Ctrl or the eraser end "
              "restores");
}

QString DrillTool::target() const
{
    return carvingTarget(m_workspace, m_restores);
}

QString DrillTool::keys() const
{
    return tr("[ ] radius · Ctrl+Shift+wheel depth · Ctrl restores · Esc cancels");
}

QWidget* DrillTool::createOptions(QWidget* parent)
{
    return connected(new DrillOptions(m_workspace, DrillOptions::Of::Drill, parent));
}

QWidget* DrillTool::connected(DrillOptions* options)
{
    const auto show = [this, options] { options->showDrawing(m_drawing.isWanted()); };
    show();
    connect(&m_drawing, &ToolMaskDrawing::changed, options, show);
    connect(options, &DrillOptions::outlineRequested, &m_drawing, &ToolMaskDrawing::want);
    return options;
}

bool DrillTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return scene && scene->orthographic && scene->context != gpu::Context::Hidden
        && scene->context != gpu::Context::CutAway;
}

core::DrillStroke DrillTool::strokeIn(const ViewContext& view, bool restore) const
{
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    core::DrillStroke stroke;
    stroke.layer = m_workspace.activeLayer();
    stroke.view = orthographicView(scene);
    stroke.mask = drillMask(settings, m_held);
    stroke.mode = settings.mode;
    stroke.floorMm = settings.floorMm;
    stroke.pressureExponent = settings.pressureExponent;
    stroke.restore = restore;
    stroke.depthMm = settings.depthMm;
    stroke.throughGaps = settings.throughGaps;
    stroke.guardMm = guardMm;
    stroke.byTime = true;
    stroke.surfaceThreshold = drillThreshold(m_workspace.volumeDisplay(), *m_workspace.volume());
    stroke.hidden = core::clipHalfSpaces(scene.clip, m_workspace.volume()->geometry);
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
    glm::dvec2 mm = m_strokeView->toViewPlaneMm(sample.position);
    if (m_aim)
        mm = m_aim->toOwn(mm);
    return {mm.x, mm.y, sample.pressure, sample.timeSeconds - m_startSeconds};
}

void DrillTool::press(const PointerSample& sample, const ViewContext& view)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !worksIn(view) || m_drawing.drawing())
        return;
    if (m_strokeView)
        return sayStrokeWaits(m_workspace);
    if (m_drawing.isWanted()) {
        m_drawing.press(sample, view);
        showCursor(sample, view.view);
        return;
    }
    m_restores = restoresWith(sample);
    m_held = sample;
    m_aim.reset();
    m_preview.forget();
    m_strokeView = view;
    m_startSeconds = sample.timeSeconds;
    if (aims()) {
        aim(sample, view);
    } else if (begin(editIn(view, m_restores), m_workspace.drillSettings().mode)) {
        extend(sample);
    }
    showCursor(sample, view.view);
}

bool DrillTool::begin(const core::Edit& edit, core::DrillMode mode)
{
    if (const auto begun = m_workspace.session()->begin(edit); !begun) {
        m_strokeView.reset();
        m_workspace.fail(begun.error());
        return false;
    }
    if (mode == core::DrillMode::Rate)
        m_resting.start();
    return true;
}

/// Whether the stroke's direction is known only once the surface under the pen is.
bool DrillTool::aims() const
{
    return !followsSurface() && m_workspace.drillSettings().sweep != Workspace::Sweep::View;
}

void DrillTool::aim(const PointerSample& sample, const ViewContext& view)
{
    m_aiming = std::make_shared<Aiming>(Aiming{.stroke = strokeIn(view, m_restores),
        .sweep = m_workspace.drillSettings().sweep,
        .tiltDegrees = sample.tiltDegrees,
        .samples = {sample}});
    const auto& scene = std::get<gpu::VolumeScene>(view.scene);
    const core::Volume& volume = *m_workspace.volume();
    SurfacePatch patch(orthographicView(scene), footprint(sample, view), 10);
    m_workspace.session()->questions().pick(
        patch.question(volume, drillThreshold(m_workspace.volumeDisplay(), volume), scene.clip),
        [tool = QPointer<DrillTool>(this), waiting = std::weak_ptr<Aiming>(m_aiming), patch](
            const core::Result<PickedVoxels>& picked) mutable {
            if (!tool || waiting.expired())
                return;
            if (picked)
                patch.take(*tool->m_workspace.volume(), *picked);
            tool->takeAim(patch);
        });
}

void DrillTool::takeAim(const SurfacePatch& surface)
{
    const std::shared_ptr<Aiming> waited = std::exchange(m_aiming, nullptr);
    Q_EMIT stepsChanged();
    if (waited->released && isStrokeOpen(*m_workspace.session())) {
        m_strokeView.reset();
        return sayStrokeCameTooLate(m_workspace);
    }
    const std::optional<glm::dvec3> place = surface.middleLps();
    if (!place) {
        m_strokeView.reset();
        m_workspace.say(tr("Nothing is seen there"));
        Q_EMIT overlayChanged();
        return;
    }
    core::DrillStroke& stroke = waited->stroke;
    const glm::dvec3 direction =
        sweepDirection(waited->sweep, stroke.view, surface.normalLps(), waited->tiltDegrees);
    m_aim.emplace(stroke.view, *place, direction);
    stroke.view = m_aim->view();
    if (!stroke.hidden)
        stroke.hidden.emplace();
    stroke.hidden->push_back(m_aim->before(2.0 * core::reachMm(stroke.mask) + stroke.depthMm));
    if (!begin(stroke, stroke.mode))
        return;
    for (const PointerSample& sample : waited->samples)
        extend(sample);
    if (!waited->released)
        return;
    m_strokeView.reset();
    m_resting.stop();
    m_workspace.session()->end(core::Ending::Commit);
    Q_EMIT overlayChanged();
}

std::vector<glm::dvec2> DrillTool::footprint(
    const PointerSample& sample, const ViewContext& view) const
{
    const glm::dvec2 middle = view.toViewPlaneMm(sample.position);
    std::vector<glm::dvec2> outline =
        core::outlineMm(drillMask(m_workspace.drillSettings(), sample), view.mmPerPixel());
    for (glm::dvec2& point : outline)
        point += middle;
    return outline;
}

void DrillTool::extend(const PointerSample& sample)
{
    if (m_aiming) {
        m_aiming->samples.push_back(sample);
        return;
    }
    m_lastSample = penSample(sample);
    m_sinceLastSample.start();
    m_workspace.session()->extend(core::PenSamples{.samples = {m_lastSample}});
}

/// A pen that does not move reports nothing, yet it goes on pressing.
void DrillTool::rest()
{
    if (m_aiming)
        return;
    core::PenSample now = m_lastSample;
    now.tSeconds += double(m_sinceLastSample.elapsed()) / 1000.0;
    if (core::EditSession* session = m_workspace.session(); session && m_strokeView)
        session->extend(core::PenSamples{.samples = {now}});
}

void DrillTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (m_drawing.drawing()) {
        m_drawing.drag(sample, view);
        showCursor(sample, view.view);
        return;
    }
    if (!m_strokeView || view.view != m_strokeView->view)
        return;
    extend(sample);
    showCursor(sample, view.view);
}

void DrillTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (m_drawing.drawing()) {
        m_drawing.release(sample, view);
        m_held = sample;
        showCursor(sample, view.view);
        return;
    }
    if (!m_strokeView)
        return;
    if (m_aiming) {
        m_aiming->released = true;
        return Q_EMIT stepsChanged();
    }
    m_strokeView.reset();
    m_resting.stop();
    m_workspace.session()->end(core::Ending::Commit);
    showCursor(sample, view.view);
}

void DrillTool::cancel()
{
    if (m_drawing.cancel()) {
        Q_EMIT overlayChanged();
        return;
    }
    // What was drawn and let go of is a stroke, though its place is not known yet.
    if (m_strokeView && !canTakeStepBack())
        drop();
}

bool DrillTool::canTakeStepBack() const
{
    return m_aiming && m_aiming->released;
}

void DrillTool::takeStepBack()
{
    drop();
}

QString DrillTool::stepText() const
{
    return waitingStrokeText();
}

void DrillTool::drop()
{
    m_strokeView.reset();
    m_resting.stop();
    const bool begun = !m_aiming;
    m_aiming.reset();
    if (core::EditSession* session = m_workspace.session(); session && begun)
        session->end(core::Ending::Rollback);
    m_workspace.say(tr("The stroke was taken back"));
    Q_EMIT overlayChanged();
    Q_EMIT stepsChanged();
}

void DrillTool::hover(const PointerSample& sample, const ViewContext& view)
{
    m_held = sample;
    if (worksIn(view) && m_workspace.session() && !m_drawing.isWanted())
        m_preview.lookAt(view, footprint(sample, view), previewAcross);
    showCursor(sample, view.view);
}

void DrillTool::leave()
{
    m_preview.forget();
    CursorTool::leave();
}

void DrillTool::showCursor(const PointerSample& sample, gpu::ViewId view)
{
    m_pressure = m_strokeView ? sample.pressure : 0.0;
    if (!m_strokeView)
        m_restores = restoresWith(sample);
    CursorTool::showCursor(sample.position, view);
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

void DrillTool::turn(int steps)
{
    Workspace::DrillSettings settings = m_workspace.drillSettings();
    settings.rotationDegrees =
        std::remainder(settings.rotationDegrees + turnDegrees * steps, 360.0);
    m_workspace.setDrillSettings(settings);
}

/// What a press would cut, on the surface, before it is made. @return whether the mask is among it
bool DrillTool::paintFootprint(QPainter& painter, const ViewContext& view) const
{
    const SurfacePatch* seen = m_strokeView ? nullptr : m_preview.patch();
    if (!seen)
        return false;
    const core::DrillStroke stroke = strokeIn(view, m_restores);
    SurfacePatch patch = *seen;
    if (!stroke.throughGaps && !m_restores)
        patch.dropBehind(depthMm() + guardMm);
    paintPatch(painter, patch, view);
    const std::optional<glm::dvec3> foot = patch.middleLps();
    if (!foot || (!followsSurface() && !aims()))
        return false;
    // The mask as it will stand, where it begins and where it ends.
    const glm::dvec3 normal = patch.normalLps();
    const glm::dvec3 direction = followsSurface()
        ? normal
        : sweepDirection(
            m_workspace.drillSettings().sweep, stroke.view, normal, m_held.tiltDegrees);
    const SweepAim standing(stroke.view, *foot, direction);
    const glm::dvec3 way = direction * (m_restores ? -depthMm() : depthMm());
    QPolygonF begins;
    QPolygonF ends;
    for (const glm::dvec2& point : core::outlineMm(stroke.mask, view.mmPerPixel())) {
        const glm::dvec3 at = standing.toLps(point);
        begins << view.toPixel(at);
        ends << view.toPixel(at + way);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(toolColour(), 1.0, Qt::DotLine));
    painter.drawPolygon(ends);
    painter.drawLine(view.toPixel(*foot), view.toPixel(*foot + way));
    drawToolOutline(painter, begins);
    return true;
}

void DrillTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !isUnderPointer(view) || !worksIn(view))
        return;
    if (m_drawing.isWanted())
        return m_drawing.paint(painter, view, cursor());
    const Workspace::DrillSettings& settings = m_workspace.drillSettings();
    const double radius = settings.radiusMm / view.mmPerPixel();

    if (!paintFootprint(painter, view))
        drawToolOutline(
            painter, maskOutline(drillMask(settings, m_held), cursor(), view.mmPerPixel()));
    painter.setBrush(toolColour());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(cursor(), 2.0, 2.0);

    const QString full = numberText(depthMm(), 1);
    const bool rate = settings.mode == core::DrillMode::Rate;
    QString depth = rate ? tr("%1 mm a second").arg(full) : tr("%1 mm deep").arg(full);
    if (m_strokeView && !rate) {
        // Mode Limit: the depth grows with the square of the pressure (DrillStroke's exponent).
        const double now = depthMm() * m_pressure * m_pressure;
        depth = tr("%1 of %2 mm").arg(numberText(now, 1), full);
    }
    QStringList lines{depth, DrillOptions::sizeText(settings), target()};
    // Where the picture itself does not say where a cut starts.
    if (m_workspace.volumeDisplay().mode != gpu::RenderMode::Surface)
        lines += startText(m_workspace);
    drawCursorLabel(painter, view.sizePixels, cursor(), radius, lines);
}

} // namespace ui

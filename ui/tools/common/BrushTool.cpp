// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/BrushTool.h"

#include "core/edits/kinds/parts/BrushPath.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/NumberText.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/aim/SeenSurface.h"
#include "ui/tools/aim/WaitingStroke.h"
#include "ui/tools/common/PenPressure.h"

#include <QPainter>
#include <QPointer>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Whether the volume is not drawn in front of segments.
bool showsSegmentsFirst(const gpu::VolumeScene& scene)
{
    return scene.context == gpu::Context::Hidden || scene.context == gpu::Context::CutAway;
}

} // namespace

/// From pen-down until the session has been told all of it.
struct BrushTool::Stroke {
    ViewContext view; ///< of pen-down; holds for the whole stroke
    core::BrushPath path; ///< without points
    StrokeMaker maker; ///< of its edit
    bool inverted = false;
    bool begun = false; ///< in the session
    bool failed = false;
    bool cancelled = false;
    bool released = false;
    bool isPressed = false; ///< the radius follows the pressure, or the tolerance does
    bool keepsRadius = false; ///< it is the tolerance
    glm::dvec3 last{0.0}; ///< LPS
    double lastPressure = 1.0;

    // 3D only.
    std::optional<SeenSurface> surface;
    Aim lastAim;
    int questions = 0; ///< not answered yet
    bool lifted = false; ///< nothing was seen on the way here
};

BrushTool::BrushTool(Workspace& workspace, Workspace::Brush brush, QObject* parent)
    : CursorTool(parent)
    , m_workspace(workspace)
    , m_brush(brush)
{
    connect(&workspace, &Workspace::brushSettingsChanged, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::activeSegmentChanged, this, &Tool::overlayChanged);
    connect(&workspace, &Workspace::activeLayerChanged, this, &Tool::overlayChanged);
    // A stroke ends with the session it was begun in.
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        if (m_stroke)
            m_stroke->cancelled = true;
        m_stroke.reset();
    });
}

BrushTool::~BrushTool() = default;

const Workspace::BrushSettings& BrushTool::settings() const
{
    return m_workspace.brushSettings(m_brush);
}

bool BrushTool::worksIn(const ViewContext& view) const
{
    const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene);
    return !scene || (scene->orthographic && (worksOnSegments() || !showsSegmentsFirst(*scene)));
}

SeenSurface BrushTool::surfaceIn(const gpu::VolumeScene& scene, bool inverted) const
{
    const core::Volume& volume = *m_workspace.volume();
    const double radiusMm = settings().radiusMm;
    // What is erased is a segment, wherever the volume steps back for it.
    const bool onSegments = worksOnSegments()
        && (showsSegmentsFirst(scene) || (inverted && scene.context != gpu::Context::Opaque));
    if (!onSegments)
        return SeenSurface(scene, volume, radiusMm, reachMm());
    const gpu::SegmentDisplay shown = m_workspace.segmentDisplay();
    std::bitset<256> segments;
    for (std::size_t label = 1; label < segments.size(); ++label)
        segments[label] = shown.visible[label];
    // The stroke changes just what it is drawn on.
    return SeenSurface(scene, volume, radiusMm, radiusMm, segments);
}

core::BrushPath BrushTool::pathIn(const ViewContext& view) const
{
    core::BrushPath path;
    path.radiusMm = settings().radiusMm;
    const auto* slice = std::get_if<gpu::SliceScene>(&view.scene);
    if (!slice)
        return path;
    using Shape = core::BrushPath::Shape;
    const bool square = settings().square;
    if (settings().disc)
        path.shape = square ? Shape::Square : Shape::Disc;
    else
        path.shape = square ? Shape::Cube : Shape::Ball;
    if (path.shape != Shape::Ball)
        path.normalLps = glm::normalize(glm::cross(slice->rightLps, slice->downLps));
    if (square)
        path.sideLps = glm::normalize(slice->rightLps);
    return path;
}

bool BrushTool::isInverse(const PointerSample& sample) const
{
    const bool asked = sample.eraserEnd || sample.modifiers.testFlag(Qt::ControlModifier);
    return asked != isTurned();
}

void BrushTool::press(const PointerSample& sample, const ViewContext& view)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !worksIn(view))
        return;
    if (m_stroke)
        return sayStrokeWaits(m_workspace);
    if (const QString why = whyNot(isInverse(sample)); !why.isEmpty()) {
        showCursor(sample, view.view);
        return m_workspace.say(why);
    }
    m_stroke = std::make_shared<Stroke>();
    m_stroke->view = view;
    m_stroke->path = pathIn(view);
    m_stroke->inverted = isInverse(sample);
    m_stroke->maker = strokeMaker(m_stroke->inverted, view);
    m_stroke->keepsRadius =
        settings().followsEdges && settings().toleranceByPressure && view.isSlice();
    m_stroke->isPressed = (settings().radiusByPressure || m_stroke->keepsRadius) && sample.isPen;
    if (view.isSlice()) {
        goTo(*m_stroke, view.toLps(sample.position), false, pressedShare(sample));
    } else {
        m_stroke->surface = surfaceIn(std::get<gpu::VolumeScene>(view.scene), m_stroke->inverted);
        m_stroke->lastAim = {
            .planeMm = view.toViewPlaneMm(sample.position), .pressure = pressedShare(sample)};
        askOnTheWay(m_stroke->lastAim);
    }
    if (m_stroke && m_stroke->failed)
        m_stroke.reset();
    showCursor(sample, view.view);
}

void BrushTool::drag(const PointerSample& sample, const ViewContext& view)
{
    if (!m_stroke || m_stroke->released || view.view != m_stroke->view.view)
        return;
    if (m_stroke->view.isSlice())
        goTo(*m_stroke, m_stroke->view.toLps(sample.position), false, pressedShare(sample));
    else
        askOnTheWay({.planeMm = m_stroke->view.toViewPlaneMm(sample.position),
            .pressure = pressedShare(sample)});
    showCursor(sample, view.view);
}

void BrushTool::release(const PointerSample& sample, const ViewContext& view)
{
    if (!m_stroke)
        return;
    m_stroke->released = true;
    if (m_stroke->questions == 0)
        finish(m_stroke);
    else
        Q_EMIT stepsChanged();
    showCursor(sample, view.view);
}

void BrushTool::cancel()
{
    if (m_stroke && !m_stroke->released)
        drop();
}

bool BrushTool::canTakeStepBack() const
{
    return m_stroke && m_stroke->released;
}

QString BrushTool::stepText() const
{
    return waitingStrokeText();
}

void BrushTool::drop()
{
    if (!m_stroke)
        return;
    const std::shared_ptr<Stroke> stroke = std::exchange(m_stroke, nullptr);
    stroke->cancelled = true;
    core::EditSession* session = m_workspace.session();
    if (session && stroke->begun)
        session->end(core::Ending::Rollback);
    m_workspace.say(tr("The stroke was taken back"));
    Q_EMIT overlayChanged();
    Q_EMIT stepsChanged();
}

void BrushTool::finish(const std::shared_ptr<Stroke>& stroke)
{
    if (stroke->begun)
        m_workspace.session()->end(core::Ending::Commit);
    else if (!stroke->failed)
        m_workspace.say(tr("Nothing is seen there"));
    if (m_stroke == stroke)
        m_stroke.reset();
    Q_EMIT stepsChanged();
}

void BrushTool::goTo(Stroke& stroke, const glm::dvec3& pointLps, bool lifted, double pressure)
{
    core::EditSession& session = *m_workspace.session();
    if (stroke.begun) {
        const bool widens = stroke.isPressed && pressesHarder(pressure, stroke.lastPressure);
        if (pointLps == stroke.last && !lifted && !widens)
            return;
        session.extend(core::PathPoints{.pointsLps = {pointLps},
            .lifted = lifted,
            .pressures = stroke.isPressed ? std::vector<double>{pressure} : std::vector<double>()});
        stroke.last = pointLps;
        stroke.lastPressure = pressure;
        return;
    }
    if (stroke.failed)
        return;
    if (stroke.released && isStrokeOpen(session)) {
        stroke.failed = true;
        return sayStrokeCameTooLate(m_workspace);
    }
    core::BrushPath path = stroke.path;
    path.pointsLps = {pointLps};
    if (stroke.isPressed)
        path.pressures = std::vector<double>{pressure};
    const core::Result<core::Edit> edit = stroke.maker(path);
    const core::Result<void> begun =
        edit ? session.begin(*edit) : core::Result<void>(tl::unexpected(edit.error()));
    stroke.last = pointLps;
    stroke.lastPressure = pressure;
    stroke.begun = bool(begun);
    stroke.failed = !begun;
    if (!begun)
        m_workspace.fail(begun.error());
}

void BrushTool::askOnTheWay(const Aim& to)
{
    const std::shared_ptr<Stroke> stroke = m_stroke;
    const Aim aim = to; // it may be the last one itself
    const Aim from = std::exchange(stroke->lastAim, aim);
    const auto cells = stroke->surface->cellsAhead(from.planeMm, aim.planeMm);
    if (cells.empty() && stroke->questions == 0)
        return follow(*stroke, from, aim);
    ++stroke->questions;
    m_workspace.session()->questions().pick(stroke->surface->question(cells),
        [tool = QPointer<BrushTool>(this), stroke, cells, from, aim](
            const core::Result<PickedVoxels>& picked) {
            if (!tool || stroke->cancelled)
                return;
            --stroke->questions;
            if (!picked) {
                stroke->failed = !stroke->begun;
                tool->m_workspace.fail(picked.error());
            } else {
                stroke->surface->take(cells, *picked);
                tool->follow(*stroke, from, aim);
            }
            if (stroke->released && stroke->questions == 0)
                tool->finish(stroke);
        });
}

void BrushTool::follow(Stroke& stroke, const Aim& from, const Aim& to)
{
    const int pieces = std::max(
        1, int(std::ceil(glm::distance(from.planeMm, to.planeMm) / stroke.surface->stepMm())));
    const auto& scene = std::get<gpu::VolumeScene>(stroke.view.scene);
    const glm::dvec3 forward = glm::normalize(scene.targetLps - scene.eyeLps);
    for (int piece = 1; piece <= pieces; ++piece) {
        const double share = double(piece) / pieces;
        const auto seen = stroke.surface->at(from.planeMm + (to.planeMm - from.planeMm) * share);
        if (!seen) {
            stroke.lifted = true;
            continue;
        }
        // What lies behind an edge is another place: nothing is drawn through the air between.
        const bool jumps = std::abs(glm::dot(*seen - stroke.last, forward)) > stroke.path.radiusMm;
        goTo(stroke, *seen, stroke.begun && (stroke.lifted || jumps),
            from.pressure + (to.pressure - from.pressure) * share);
        stroke.lifted = false;
    }
}

void BrushTool::hover(const PointerSample& sample, const ViewContext& view)
{
    showCursor(sample, view.view);
}

void BrushTool::showCursor(const PointerSample& sample, gpu::ViewId view)
{
    m_pressure =
        m_stroke && m_stroke->isPressed && !m_stroke->keepsRadius ? pressedShare(sample) : 1.0;
    m_inverted = m_stroke ? m_stroke->inverted : isInverse(sample);
    CursorTool::showCursor(sample.position, view);
}

double BrushTool::radiusAfter(double radiusMm, int steps)
{
    const double step = radiusMm < 10.0 ? 0.5 : radiusMm < 30.0 ? 1.0 : 2.0;
    return std::clamp(
        std::round((radiusMm + steps * step) / step) * step, minimumRadiusMm, maximumRadiusMm);
}

void BrushTool::changeRadius(int steps)
{
    Workspace::BrushSettings changed = settings();
    changed.radiusMm = radiusAfter(changed.radiusMm, steps);
    m_workspace.setBrushSettings(m_brush, changed);
}

QString BrushTool::shapeText(core::BrushPath::Shape shape)
{
    switch (shape) {
    case core::BrushPath::Shape::Ball:
        return tr(", a ball");
    case core::BrushPath::Shape::Disc:
        return tr(", this slice");
    case core::BrushPath::Shape::Square:
        return tr(", a square in this slice");
    case core::BrushPath::Shape::Cube:
        return tr(", a cube");
    }
    return {};
}

void BrushTool::paintOverlay(QPainter& painter, const ViewContext& view) const
{
    if (!m_workspace.session() || !isUnderPointer(view) || !worksIn(view))
        return;
    const double radius =
        m_pressure * (m_stroke ? m_stroke->path.radiusMm : settings().radiusMm) / view.mmPerPixel();
    // A stroke keeps the shape that it began with.
    const core::BrushPath::Shape shape = m_stroke ? m_stroke->path.shape : pathIn(view).shape;
    const auto draw = core::isSquare(shape) ? drawCursorSquare : drawCursorRing;
    draw(painter, cursor(), radius, colour(), m_inverted);

    QString size = tr("radius %1 mm").arg(numberText(settings().radiusMm, 1));
    if (view.isSlice())
        size += shapeText(shape);
    QStringList lines{action(m_inverted), size};
    const QString followed = view.isSlice() ? edges() : QString();
    if (!followed.isEmpty()) {
        // What lies under it decides.
        drawCursorCross(painter, cursor(), colour());
        lines += followed;
    }
    if (const QString text = limits(); !text.isEmpty())
        lines += text;
    drawCursorLabel(painter, view.sizePixels, cursor(), radius, lines);
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/views/SliceView.h"

#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/base/TimeText.h"
#include "ui/geometry/OrientationLetters.h"
#include "ui/menus/SliceTurnEntries.h"
#include "ui/menus/VoxelMenu.h"
#include "ui/overlays/Annotations.h"
#include "ui/overlays/ClipOutline.h"
#include "ui/overlays/MeasurementLines.h"
#include "ui/overlays/PlaneOutline.h"
#include "ui/overlays/ReferenceLines.h"
#include "ui/views/EarlyPicture.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/InitialDisplay.h"
#include "ui/workspace/Refinement.h"

#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ui {

namespace {

constexpr double fitMarginPixels = 26.0; // room for the letters at the edges
constexpr double leastMmPerPixel = 1e-3;
constexpr double greatestMmPerPixel = 100.0;
constexpr int greatestSlabReach = 100; // slices on either side
constexpr Qt::KeyboardModifiers slabKeys = Qt::ControlModifier | Qt::ShiftModifier;

QColor colourOf(SliceOrientation orientation)
{
    switch (orientation) {
    case SliceOrientation::Axial:
        return theme::axial;
    case SliceOrientation::Sagittal:
        return theme::sagittal;
    case SliceOrientation::Coronal:
        break;
    }
    return theme::coronal;
}

QString titleOf(SliceOrientation orientation)
{
    switch (orientation) {
    case SliceOrientation::Axial:
        return QStringLiteral("AXIAL");
    case SliceOrientation::Sagittal:
        return QStringLiteral("SAGITTAL");
    case SliceOrientation::Coronal:
        break;
    }
    return QStringLiteral("CORONAL");
}

/// The standard plane that lies across a direction, in its colour.
QColor colourAcross(const glm::dvec3& directionLps)
{
    const glm::dvec3 along = glm::abs(directionLps);
    return along.z > along.x && along.z > along.y ? theme::axial
        : along.x > along.y                       ? theme::sagittal
                                                  : theme::coronal;
}

/// Mode and thickness of a slab, and what tools work on; empty if there is none.
QString slabText(const gpu::SceneSlab& slab)
{
    const QString thickness = QStringLiteral("%1 mm slab · tools work on the middle slice")
                                  .arg((2 * slab.reach + 1) * slab.stepMm, 0, 'f', 1);
    switch (slab.mode) {
    case gpu::SlabMode::Maximum:
        return QStringLiteral("MIP ") + thickness;
    case gpu::SlabMode::Minimum:
        return QStringLiteral("MinIP ") + thickness;
    case gpu::SlabMode::Mean:
        return QStringLiteral("mean ") + thickness;
    case gpu::SlabMode::Off:
        break;
    }
    return {};
}

} // namespace

SliceView::SliceView(
    Workspace& workspace, gpu::ViewId view, SliceOrientation orientation, QWidget* parent)
    : SliceView(workspace, view, sliceAxes(orientation), titleOf(orientation),
        colourOf(orientation), parent)
{
}

SliceView::SliceView(Workspace& workspace, gpu::ViewId view, const SliceAxes& axes,
    const QString& title, const QColor& colour, QWidget* parent)
    : ImageView(workspace, view, parent)
    , m_axes(axes)
    , m_title(title)
    , m_colour(colour)
{
    connect(&workspace, &Workspace::sessionChanged, this, &SliceView::openVolume);
    connect(&workspace, &Workspace::clipChanged, this, qOverload<>(&SliceView::update));
    connect(&workspace, &Workspace::growSettingsChanged, this, qOverload<>(&SliceView::update));
    connect(&workspace.refinement(), &Refinement::lookChanged, this, [this] { requestFrame(); });
    connect(&workspace.refinement(), &Refinement::changed, this, [this] { requestFrame(); });
    // As urgent as the 3D view's, which takes longer: else that would come first.
    connect(&workspace.chunks(), &Chunks::pictureChanged, this, &SliceView::requestMovingFrame);
    connect(&workspace.plane(), &CuttingPlane::changed, this, qOverload<>(&SliceView::update));
    openVolume();
}

void SliceView::openVolume()
{
    if (const core::Volume* volume = shownVolume())
        m_stack = sliceStack(volume->geometry, m_axes.normalLps);
    resetView();
}

void SliceView::setAxes(const SliceAxes& axes)
{
    m_axes = axes;
    if (const core::Volume* volume = shownVolume())
        m_stack = sliceStack(volume->geometry, m_axes.normalLps);
}

void SliceView::resetView()
{
    m_fitted = true;
    m_turn = {};
    if (const core::Volume* volume = shownVolume()) {
        m_centreLps = volume->geometry.toWorld(0.5 * glm::dvec3(volume->geometry.size - 1));
        m_mmPerPixel = fittingMmPerPixel();
    }
    requestFrame();
}

std::optional<SliceView::Place> SliceView::place() const
{
    if (m_fitted)
        return std::nullopt;
    return Place{m_centreLps, m_mmPerPixel};
}

void SliceView::setPlace(const Place& place)
{
    m_fitted = false;
    m_centreLps = place.centreLps;
    m_mmPerPixel = std::clamp(place.mmPerPixel, leastMmPerPixel, greatestMmPerPixel);
    requestFrame();
}

void SliceView::lookWhereLooks(const SliceView& other)
{
    m_fitted = false;
    m_mmPerPixel = other.m_mmPerPixel;
    const glm::dvec3& across = other.m_axes.normalLps;
    m_centreLps = other.m_centreLps + across * glm::dot(m_centreLps - other.m_centreLps, across);
    requestMovingFrame();
}

void SliceView::setTurn(const SliceTurn& turn)
{
    if (turn == m_turn)
        return;
    m_turn = turn;
    if (m_fitted)
        m_mmPerPixel = fittingMmPerPixel();
    requestFrame();
}

double SliceView::fittingMmPerPixel() const
{
    const core::Volume* volume = shownVolume();
    if (!volume)
        return 1.0;
    const SliceAxes onScreen = axesOnScreen();
    glm::dvec2 half(0.0);
    for (const glm::dvec3& corner : volume->geometry.cornersLps()) {
        const glm::dvec3 offset = corner - m_centreLps;
        half.x = std::max(half.x, std::abs(glm::dot(offset, onScreen.rightLps)));
        half.y = std::max(half.y, std::abs(glm::dot(offset, onScreen.downLps)));
    }
    const double across = std::max(width() - 2.0 * fitMarginPixels, 32.0);
    const double along = std::max(height() - 2.0 * fitMarginPixels, 32.0);
    return std::max(2.0 * half.x / across, 2.0 * half.y / along);
}

glm::dvec3 SliceView::throughLps() const
{
    return early() ? initialCrosshairLps(early()->volume.geometry) : workspace().crosshairLps();
}

void SliceView::passThrough(const glm::dvec3& placeLps)
{
    workspace().setCrosshairLps(placeLps);
}

core::WindowLevel SliceView::windowLevel() const
{
    return early() ? early()->volume.defaultWindow : workspace().windowLevel();
}

bool SliceView::looksAt(const core::EarlySlice& early) const
{
    gpu::SliceScene scene;
    scene.centreLps = initialCrosshairLps(early.volume.geometry);
    scene.rightLps = m_axes.rightLps;
    scene.downLps = m_axes.downLps;
    return showsEarlySlice(early, scene);
}

QImage SliceView::earlyPictureOf(const gpu::Scene& scene, const QSize& pixels) const
{
    return earlyPicture(*early(), std::get<gpu::SliceScene>(scene), pixels);
}

int SliceView::sliceNumber() const
{
    return m_stack.numberAt(throughLps());
}

int SliceView::sliceCount() const
{
    return m_stack.count;
}

void SliceView::goToSlice(int number)
{
    if (!early())
        passThrough(m_stack.movedTo(throughLps(), number));
}

gpu::Scene SliceView::scene() const
{
    gpu::SliceScene scene;
    // The pan decides where in the plane, the place that it passes through which plane.
    const double depth = glm::dot(throughLps() - m_centreLps, m_axes.normalLps);
    scene.centreLps = m_centreLps + depth * m_axes.normalLps;
    const SliceAxes onScreen = axesOnScreen();
    scene.rightLps = onScreen.rightLps;
    scene.downLps = onScreen.downLps;
    scene.mmPerPixel = m_mmPerPixel;
    scene.window = windowLevel();
    scene.inverted = early() ? early()->volume.displayInverted : workspace().viewOptions().inverted;
    scene.showCarved = workspace().viewOptions().showCarved;
    scene.carvedAsHole = workspace().viewOptions().carvedAsHole;
    if (!early()) {
        scene.slab = slab();
        scene.contour = workspace().refinement().contour();
        scene.chunks = workspace().chunks().areas();
    }
    return scene;
}

gpu::SceneSlab SliceView::slab() const
{
    const Workspace::ViewOptions& options = workspace().viewOptions();
    if (options.slabMode == gpu::SlabMode::Off)
        return {};
    const double beside = 0.5 * (options.slabMm / m_stack.stepMm - 1.0);
    const glm::dvec3 here = throughLps();
    const glm::dvec3 onSlice = m_stack.movedTo(here, m_stack.numberAt(here));
    return {.mode = options.slabMode,
        .reach = int(std::clamp(std::round(beside), 1.0, double(greatestSlabReach))),
        .stepMm = m_stack.stepMm,
        .offsetMm = glm::dot(onSlice - here, axesOnScreen().normalLps)};
}

void SliceView::thickenSlab(double steps)
{
    // Touchpads turn in fractions of a step.
    m_slabRest += steps;
    const int whole = int(m_slabRest);
    m_slabRest -= whole;
    if (whole == 0 || early())
        return;
    Workspace::ViewOptions options = workspace().viewOptions();
    if (options.slabMode == gpu::SlabMode::Off) {
        options.slabMode = gpu::SlabMode::Maximum;
    } else {
        const int reach = std::clamp(slab().reach + whole, 1, greatestSlabReach);
        options.slabMm = (2 * reach + 1) * m_stack.stepMm;
    }
    workspace().setViewOptions(options);
}

bool SliceView::ownsWheel(Qt::KeyboardModifiers modifiers) const
{
    return (modifiers & slabKeys) == slabKeys;
}

ImageView::Gesture SliceView::gestureFor(
    Qt::MouseButton button, Qt::KeyboardModifiers keys, bool toolWorksHere) const
{
    switch (button) {
    case Qt::LeftButton:
        if (m_awaitsBox)
            return Gesture::Box;
        if (toolWorksHere)
            return Gesture::Tool;
        // A stroke that misses its view must not change the grey scale (UX §4.2).
        return workspace().activeTool() ? Gesture::Pan : Gesture::Window;
    case Qt::MiddleButton:
        return Gesture::Pan;
    case Qt::RightButton:
        if (keys & Qt::ControlModifier)
            return Gesture::Box;
        return workspace().activeTool() ? Gesture::Window : Gesture::Zoom;
    default:
        return Gesture::None;
    }
}

void SliceView::dragged(Gesture gesture, const QPointF& from, const QPointF& to)
{
    const QPointF moved = to - from;
    const SliceAxes onScreen = axesOnScreen();
    switch (gesture) {
    case Gesture::Window:
        workspace().setWindowLevel(windowAfterDrag(workspace().windowLevel(), moved));
        break;
    case Gesture::Pan:
        m_fitted = false;
        m_centreLps -=
            (onScreen.rightLps * moved.x() + onScreen.downLps * moved.y()) * m_mmPerPixel;
        requestMovingFrame();
        Q_EMIT placeChanged();
        break;
    case Gesture::Zoom:
        zoomBy(std::exp(-moved.y() * 0.008), rect().toRectF().center());
        break;
    case Gesture::Box:
        if (!m_box)
            m_box = QRectF(from, from);
        m_box->setBottomRight(to);
        update();
        break;
    default:
        break;
    }
}

void SliceView::dragEnded(Gesture gesture)
{
    if (gesture != Gesture::Box || !m_box)
        return;
    const QRectF box = std::exchange(m_box, std::nullopt)->normalized();
    update();
    if (box.width() < 2.0 || box.height() < 2.0)
        return Q_EMIT boxAbandoned();
    const ViewContext view = context();
    Q_EMIT boxDrawn({.kind = core::Measurement::Kind::Rectangle,
        .pointsLps = {
            view.toLps(box.topLeft()), view.toLps(box.topRight()), view.toLps(box.bottomLeft())}});
}

void SliceView::dragAbandoned()
{
    m_box.reset();
    update();
    Q_EMIT boxAbandoned();
}

void SliceView::setAwaitsBox(bool awaits)
{
    m_awaitsBox = awaits;
}

void SliceView::zoomBy(double factor, const QPointF& at)
{
    const glm::dvec3 held = context().toLps(at);
    m_fitted = false;
    m_mmPerPixel = std::clamp(m_mmPerPixel / factor, leastMmPerPixel, greatestMmPerPixel);
    m_centreLps += held - context().toLps(at);
    requestMovingFrame();
    Q_EMIT placeChanged();
}

void SliceView::clicked(const QPointF& at)
{
    if (m_awaitsBox)
        Q_EMIT boxAbandoned();
    else if (!workspace().activeTool())
        workspace().setCrosshairLps(context().toLps(at));
}

void SliceView::menuAsked(const QPointF& at)
{
    auto* menu = new VoxelMenu(workspace(), *this, mapToGlobal(at.toPoint()));
    menu->addAtEnd([this](QMenu& more) { listTurns(more); });
    menu->openAbout(context().toLps(at));
}

void SliceView::listTurns(QMenu& menu)
{
    menu.addSeparator();
    QMenu* turns = menu.addMenu(tr("Flip and turn this view"));
    turns->setObjectName(QStringLiteral("turnsOfView"));
    for (const SliceTurnEntry& each : sliceTurnEntries()) {
        QAction* action =
            turns->addAction(each.text, this, [this, &each] { setTurn(each.after(m_turn)); });
        action->setEnabled(each.after(m_turn) != m_turn);
    }
}

void SliceView::hovered(const PointerSample& sample)
{
    if (sample.modifiers & Qt::ShiftModifier)
        workspace().setCrosshairLps(context().toLps(sample.position));
    if (workspace().activeTool())
        update();
}

void SliceView::wheelTurned(double steps, const QPointF& at, Qt::KeyboardModifiers modifiers)
{
    if ((modifiers & slabKeys) == slabKeys) {
        thickenSlab(steps);
        return;
    }
    if (modifiers & Qt::ControlModifier) {
        zoomBy(std::pow(1.15, steps), at);
        return;
    }
    // Touchpads turn in fractions of a step.
    m_wheelRest += -steps * ((modifiers & Qt::ShiftModifier) ? 5.0 : 1.0);
    const int whole = int(m_wheelRest);
    m_wheelRest -= whole;
    if (whole != 0)
        goToSlice(sliceNumber() + whole);
}

void SliceView::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Escape:
        // A box that is being drawn is the pointer's.
        if (!m_awaitsBox || m_box)
            return ImageView::keyPressEvent(event);
        return Q_EMIT boxAbandoned();
    case Qt::Key_Up:
        return goToSlice(sliceNumber() - 1);
    case Qt::Key_Down:
        return goToSlice(sliceNumber() + 1);
    case Qt::Key_PageUp:
        return goToSlice(sliceNumber() - 10);
    case Qt::Key_PageDown:
        return goToSlice(sliceNumber() + 10);
    case Qt::Key_Home:
        return goToSlice(0);
    case Qt::Key_End:
        return goToSlice(sliceCount() - 1);
    default:
        ImageView::keyPressEvent(event);
    }
}

void SliceView::resizeEvent(QResizeEvent* event)
{
    if (m_fitted)
        m_mmPerPixel = fittingMmPerPixel();
    ImageView::resizeEvent(event);
}

QString SliceView::windowText() const
{
    const core::Volume& volume = *shownVolume();
    const core::WindowLevel window = windowLevel();
    const double span = volume.maximum - volume.minimum;
    QString text = QStringLiteral("W %1  L %2")
                       .arg(valueText(window.width, QString(), span),
                           valueText(window.centre, volume.unit, span));
    for (const WindowPreset& preset : windowPresets(volume)) {
        if (preset.window == window)
            return text + QStringLiteral(" · ") + preset.name;
    }
    return text;
}

void SliceView::paintCross(QPainter& painter, const ViewContext& shown)
{
    // Each line is another standard plane, seen from its edge: it lies across the other line.
    const auto& slice = std::get<gpu::SliceScene>(shown.scene);
    paintCrosshair(painter, rect(), shown.toPixel(throughLps()), colourAcross(slice.downLps),
        colourAcross(slice.rightLps));
}

void SliceView::paintOtherSlices(QPainter& painter, const ViewContext& shown) const
{
    std::vector<ReferencePlane> planes;
    for (const SliceOrientation each :
        {SliceOrientation::Axial, SliceOrientation::Sagittal, SliceOrientation::Coronal})
        planes.push_back({.pointLps = workspace().crosshairLps(),
            .normalLps = sliceAxes(each).normalLps,
            .colour = colourOf(each)});
    paintReferenceLines(
        painter, shown, planes, shownVolume()->geometry, shown.toPixel(workspace().crosshairLps()));
}

void SliceView::paintAnnotations(QPainter& painter, const ViewContext& shown)
{
    const core::Volume& volume = *shownVolume();
    const Workspace::ViewOptions& options = workspace().viewOptions();
    const auto& slice = std::get<gpu::SliceScene>(shown.scene);

    if (!early()) {
        paintClipSection(painter, shown, workspace().clip(), volume.geometry);
        if (const auto box = growBoxOf(workspace().growSettings(), volume.geometry))
            paintBoxSection(painter, shown, *box, volume.geometry, theme::good);
        paintMeasurements(painter, shown, workspace());
        paintPlaneLine(painter, shown, workspace().plane());
    }
    if (options.referenceLines && !early())
        paintOtherSlices(painter, shown);
    if (options.showCrosshair)
        paintCross(painter, shown);
    paintEdgeLetters(painter, rect(), slice.rightLps, slice.downLps);

    const double position = glm::dot(slice.centreLps, m_axes.normalLps);
    const glm::dvec3 side = position < 0.0 ? -m_axes.normalLps : m_axes.normalLps;
    const int number = m_stack.numberAt(slice.centreLps);
    // Screen pixels per voxel of the volume.
    const glm::dvec3 spacing = volume.geometry.spacingMm();
    const double zoom = std::min({spacing.x, spacing.y, spacing.z}) / slice.mmPerPixel;

    CornerTexts texts;
    texts.title = title();
    texts.titleColour = barColour();
    if (options.showPatient)
        texts.topLeft = patientLines(volume.identity);
    texts.topRight = {studyText(volume.identity), seriesText(volume.identity), timeText(volume)};
    texts.bottomLeft = {QStringLiteral("zoom %1").arg(zoom, 0, 'f', 1), windowText()};
    if (slice.slab.mode != gpu::SlabMode::Off)
        texts.bottomLeft.append(slabText(slice.slab));
    if (const QString caution = workspace().refinement().caution(); !early() && !caution.isEmpty())
        texts.bottomLeft.append(caution);
    if (m_turn.mirrored)
        texts.bottomLeft.append(tr("mirrored"));
    texts.bottomRight = {QStringLiteral("%1 / %2 · %3 %4 mm")
                             .arg(number + 1)
                             .arg(m_stack.count)
                             .arg(directionLetters(side), numberText(std::abs(position), 1))};
    paintCorners(painter, rect(), texts);
    paintScaleBar(painter, rect(), height() - 34, slice.mmPerPixel);
    if (m_box) {
        for (const QPen& pen :
            {QPen(QColor(0, 0, 0, 140), 3.0), QPen(theme::accent, 1.0, Qt::DashLine)}) {
            painter.setPen(pen);
            painter.drawRect(m_box->normalized());
        }
    }
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
// What pointer, wheel and keys do to a slice when no tool takes them.
#include "ui/menus/ColourMapEntries.h"
#include "ui/menus/InterpolationEntries.h"
#include "ui/menus/SegmentLookEntries.h"
#include "ui/menus/SegmentViews.h"
#include "ui/menus/SliceTurnEntries.h"
#include "ui/menus/VoxelMenu.h"
#include "ui/views/SliceView.h"

#include <QKeyEvent>
#include <QMenu>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr Qt::KeyboardModifiers slabKeys = Qt::ControlModifier | Qt::ShiftModifier;
constexpr double handleShare = 0.4; // of the shorter side: from the crosshair to its handles
constexpr double handleReachPixels = 9.0;

} // namespace

bool SliceView::turnsCrosshair() const
{
    return m_planes && !workspace().activeTool() && workspace().viewOptions().showCrosshair;
}

std::vector<SliceView::Handle> SliceView::handles(const ViewContext& view) const
{
    if (!turnsCrosshair())
        return {};
    std::vector<Handle> found;
    const QPointF cross = view.toPixel(throughLps());
    const double away = handleShare * std::min(width(), height());
    for (const SliceOrientation each : MprPlanes::all) {
        if (each == m_orientation)
            continue;
        for (const double side : {-1.0, 1.0})
            found.push_back({each, cross + side * away * directionOf(each, view)});
    }
    return found;
}

std::optional<SliceOrientation> SliceView::grabbedAt(const QPointF& at) const
{
    for (const Handle& each : handles(context())) {
        const QPointF way = at - each.at;
        if (std::hypot(way.x(), way.y()) <= handleReachPixels)
            return each.plane;
    }
    return std::nullopt;
}

void SliceView::turnCrosshair(const QPointF& from, const QPointF& to, bool alone)
{
    if (!m_grabbed)
        m_grabbed = grabbedAt(from);
    if (!m_grabbed)
        return;
    const QPointF cross = context().toPixel(throughLps());
    const QPointF before = from - cross;
    const QPointF after = to - cross;
    double radians = std::atan2(before.x() * after.y() - before.y() * after.x(),
        before.x() * after.x() + before.y() * after.y());
    if (m_turn.mirrored)
        radians = -radians; // clockwise on the screen is the other way round in the patient
    if (alone)
        m_planes->turnOne(*m_orientation, *m_grabbed, radians);
    else
        m_planes->turnOthers(*m_orientation, radians);
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
        const int reach = std::clamp(slabReach() + whole, 1, greatestSlabReach);
        options.slabMm = (2 * reach + 1) * m_stack.stepMm;
    }
    workspace().setViewOptions(options);
}

bool SliceView::ownsWheel(Qt::KeyboardModifiers modifiers) const
{
    return (modifiers & slabKeys) == slabKeys;
}

ImageView::Gesture SliceView::gestureFor(
    Qt::MouseButton button, const PointerSample& sample, bool toolWorksHere) const
{
    switch (button) {
    case Qt::LeftButton:
        if (m_awaitsBox)
            return Gesture::Box;
        if (toolWorksHere)
            return Gesture::Tool;
        if (grabbedAt(sample.position))
            return (sample.modifiers & Qt::ControlModifier) ? Gesture::TurnOne : Gesture::Turn;
        // A stroke that misses its view must not change the grey scale (UX §4.2).
        return workspace().activeTool() ? Gesture::Pan : Gesture::Window;
    case Qt::MiddleButton:
        return Gesture::Pan;
    case Qt::RightButton:
        if (sample.modifiers & Qt::ControlModifier)
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
        // A gesture goes on where its study is closed meanwhile.
        if (const core::Volume* volume = workspace().volume()) {
            workspace().setWindowLevel(
                windowAfterDrag(volume->encoding, workspace().windowLevel(), moved));
        }
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
    case Gesture::Turn:
    case Gesture::TurnOne:
        turnCrosshair(from, to, gesture == Gesture::TurnOne);
        break;
    case Gesture::Box:
        if (!m_box)
            m_box = QRectF(from, from);
        m_box->setBottomRight(to);
        update();
        break;
    case Gesture::None:
    case Gesture::Tool:
    case Gesture::Rotate:
        break; // not a slice's
    }
}

void SliceView::dragEnded(Gesture gesture)
{
    m_grabbed.reset();
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

bool SliceView::clicked(const QPointF& at)
{
    if (!m_awaitsBox && workspace().activeTool())
        return false;
    if (m_awaitsBox)
        Q_EMIT boxAbandoned();
    else
        workspace().setCrosshairLps(context().toLps(at));
    return true;
}

void SliceView::menuAsked(const QPointF& at)
{
    auto* menu = new VoxelMenu(workspace(), *this, mapToGlobal(at.toPoint()));
    menu->addAtEnd([this](QMenu& more) {
        listTurns(more);
        addViewEntries(more);
    });
    menu->openAbout(context().toLps(at));
}

void SliceView::activateSegmentAt(const QPointF& at)
{
    ui::activateSegmentAt(workspace(), context().toLps(at));
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
    addColourMaps(menu, workspace());
    addInterpolations(menu, workspace());
    QMenu* segments = menu.addMenu(tr("Segments in this view"));
    segments->setObjectName(QStringLiteral("segmentsOfView"));
    segments->setToolTipsVisible(true);
    addSegmentLook(*segments, workspace(),
        {.get = [this] { return m_segmentLook; },
            .set = [this](const Workspace::SegmentLook& look) { setSegmentLook(look); }});
}

void SliceView::hovered(const PointerSample& sample)
{
    if (sample.modifiers & Qt::ShiftModifier)
        workspace().setCrosshairLps(context().toLps(sample.position));
    // The cursor of a tool moves, and handles come with the pointer.
    if (workspace().activeTool() || turnsCrosshair())
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
    m_wheelRest += steps * ((modifiers & Qt::ShiftModifier) ? 5.0 : 1.0);
    const int whole = int(m_wheelRest);
    m_wheelRest -= whole;
    if (whole != 0)
        goToSlice(sliceNumber() + whole);
}

void SliceView::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Z && m_lensHeld) {
        // A key that is held repeats itself: pressed and released.
        if (!event->isAutoRepeat())
            holdLens(false);
        return;
    }
    ImageView::keyReleaseEvent(event);
}

void SliceView::keyPressEvent(QKeyEvent* event)
{
    constexpr Qt::KeyboardModifiers commands =
        Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    switch (event->key()) {
    case Qt::Key_Z:
        if ((event->modifiers() & commands) != Qt::NoModifier)
            return ImageView::keyPressEvent(event);
        return holdLens(true);
    case Qt::Key_Escape:
        // A box that is being drawn is the pointer's.
        if (!m_awaitsBox || m_box)
            return ImageView::keyPressEvent(event);
        return Q_EMIT boxAbandoned();
    // Up leads towards the head, as in 3D Slicer and ITK-SNAP: slices are numbered from the feet.
    case Qt::Key_Up:
        return goToSlice(sliceNumber() + 1);
    case Qt::Key_Down:
        return goToSlice(sliceNumber() - 1);
    case Qt::Key_PageUp:
        return goToSlice(sliceNumber() + 10);
    case Qt::Key_PageDown:
        return goToSlice(sliceNumber() - 10);
    case Qt::Key_Home:
        return goToSlice(0);
    case Qt::Key_End:
        return goToSlice(sliceCount() - 1);
    default:
        ImageView::keyPressEvent(event);
    }
}

} // namespace ui

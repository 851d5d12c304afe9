// SPDX-License-Identifier: Apache-2.0
#include "ui/views/SliceView.h"

#include "ui/menus/SegmentLookEntries.h"
#include "ui/overlays/Annotations.h"
#include "ui/views/EarlyPicture.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/InitialDisplay.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Refinement.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double fitMarginPixels = 26.0; // room for the letters at the edges

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

} // namespace

SliceView::SliceView(
    Workspace& workspace, gpu::ViewId view, SliceOrientation orientation, QWidget* parent)
    : SliceView(workspace, view, sliceAxes(orientation), titleOf(orientation),
        sliceColour(orientation), parent)
{
}

SliceView::SliceView(Workspace& workspace, gpu::ViewId view, const SliceAxes& axes,
    const QString& title, const QColor& colour, QWidget* parent)
    : ImageView(workspace, view, parent)
    , m_axes(axes)
    , m_lookButton(new SegmentLookButton(workspace,
          {.get = [this] { return m_segmentLook; },
              .set = [this](const Workspace::SegmentLook& look) { setSegmentLook(look); }},
          this))
    , m_title(title)
    , m_colour(colour)
    , m_lens(workspace.frames(), view)
{
    connect(&workspace, &Workspace::sessionChanged, this, &SliceView::openVolume);
    connect(&workspace, &Workspace::clipChanged, this, qOverload<>(&SliceView::update));
    connect(&workspace, &Workspace::growSettingsChanged, this, qOverload<>(&SliceView::update));
    connect(&workspace.refinement(), &Refinement::lookChanged, this, [this] { requestFrame(); });
    connect(&workspace.refinement(), &Refinement::changed, this, [this] { requestFrame(); });
    // As urgent as the 3D view's, which takes longer: else that would come first.
    connect(&workspace.chunks(), &Chunks::pictureChanged, this, &SliceView::requestMovingFrame);
    connect(&workspace.seeds(), &PendingSeeds::ghostChanged, this, &SliceView::requestMovingFrame);
    connect(&workspace.plane(), &CuttingPlane::changed, this, qOverload<>(&SliceView::update));
    openVolume();
}

SliceView::SliceView(Workspace& workspace, gpu::ViewId view, SliceOrientation orientation,
    MprPlanes& planes, QWidget* parent)
    : SliceView(workspace, view, orientation, parent)
{
    m_orientation = orientation;
    m_planes = &planes;
    setReferencePlanes(planes);
    connect(&planes, &MprPlanes::changed, this, [this, orientation] {
        setAxes(m_planes->axes(orientation));
        requestMovingFrame();
    });
}

void SliceView::setReferencePlanes(const MprPlanes& planes)
{
    m_referencePlanes = &planes;
    connect(&planes, &MprPlanes::changed, this, qOverload<>(&SliceView::update));
}

void SliceView::openVolume()
{
    holdLens(false);
    m_segmentLook = {};
    m_lookButton->showState();
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

void SliceView::centreOn(const glm::dvec3& placeLps)
{
    if (m_fitted && !isVisible())
        return;
    m_fitted = false;
    m_centreLps = placeLps;
    requestFrame();
}

void SliceView::setSegmentLook(const Workspace::SegmentLook& look)
{
    Workspace::SegmentLook wanted = look;
    if (wanted.fillPercent)
        wanted.fillPercent = std::clamp(*wanted.fillPercent, Workspace::leastSegmentFill, 100);
    if (wanted == m_segmentLook)
        return;
    m_segmentLook = wanted;
    m_lookButton->showState();
    requestFrame();
}

gpu::SegmentDisplay SliceView::segmentDisplay() const
{
    return workspace().segmentDisplay(m_segmentLook);
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
    scene.interpolation =
        workspace().viewOptions().interpolation.value_or(gpu::Interpolation::Linear);
    scene.inverted = early() ? early()->volume.displayInverted : workspace().viewOptions().inverted;
    scene.showCarved = workspace().viewOptions().showCarved;
    scene.carvedAsHole = workspace().viewOptions().carvedAsHole;
    if (!early()) {
        scene.colours = workspace().viewOptions().colours;
        scene.slab = slab();
        scene.contour = workspace().refinement().contour();
        scene.chunks = workspace().chunks().areas();
        if (!scene.chunks && workspace().viewOptions().showSegments)
            scene.chunks = workspace().seeds().ghost().areas;
    }
    return scene;
}

gpu::SceneSlab SliceView::slab() const
{
    const Workspace::ViewOptions& options = workspace().viewOptions();
    if (options.slabMode == gpu::SlabMode::Off)
        return {};
    const int slices = 2 * slabReach() + 1;
    // All samples of a pixel take time; both numbers are odd.
    const int affordable = std::max(1, (mostSlabSamples / slices - 1) | 1);
    const int perSlice = std::min(samplesPerSlice(shownVolume()->geometry, m_stack), affordable);
    const glm::dvec3 here = throughLps();
    const glm::dvec3 onSlice = m_stack.movedTo(here, m_stack.numberAt(here));
    return {.mode = options.slabMode,
        .reach = (slices * perSlice - 1) / 2,
        .stepMm = m_stack.stepMm / perSlice,
        .offsetMm = glm::dot(onSlice - here, axesOnScreen().normalLps)};
}

int SliceView::slabReach() const
{
    const double beside = 0.5 * (workspace().viewOptions().slabMm / m_stack.stepMm - 1.0);
    return int(std::clamp(std::round(beside), 1.0, double(greatestSlabReach)));
}

void SliceView::resizeEvent(QResizeEvent* event)
{
    if (m_fitted)
        m_mmPerPixel = fittingMmPerPixel();
    m_lookButton->showState();
    ImageView::resizeEvent(event);
}

} // namespace ui

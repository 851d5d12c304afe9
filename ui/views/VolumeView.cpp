// SPDX-License-Identifier: Apache-2.0
#include "ui/views/VolumeView.h"

#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/base/TimeText.h"
#include "ui/overlays/Annotations.h"
#include "ui/overlays/ClipOutline.h"
#include "ui/overlays/MeasurementLines.h"
#include "ui/overlays/PieceBadges.h"
#include "ui/views/ContextSwitch.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/OpeningView.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Refinement.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

namespace {

/// The name under which the right eye's frames are asked for.
gpu::ViewId otherEye(gpu::ViewId view)
{
    return view + 1000;
}

/// The camera that a picture was drawn with.
Camera cameraOf(const gpu::VolumeScene& scene)
{
    Camera camera;
    camera.targetLps = scene.targetLps;
    camera.towardsViewer = glm::normalize(scene.eyeLps - scene.targetLps);
    camera.up = scene.up;
    camera.heightMm = scene.heightMm;
    return camera;
}

} // namespace

VolumeView::VolumeView(Workspace& workspace, gpu::ViewId view, QWidget* parent)
    : ImageView(workspace, view, parent)
    , m_readout(workspace)
    , m_switch(new ContextSwitch(workspace, this))
{
    connect(&workspace, &Workspace::sessionChanged, this, &VolumeView::openVolume);
    connect(&workspace, &Workspace::sessionChanged, this, &VolumeView::placeSwitch);
    connect(&workspace, &Workspace::volumeDisplayChanged, this, &VolumeView::placeSwitch);
    connect(&workspace, &Workspace::documentChanged, this, &VolumeView::placeSwitch);
    connect(&workspace, &Workspace::clipChanged, this, &VolumeView::requestMovingFrame);
    connect(&workspace, &Workspace::growSettingsChanged, this, qOverload<>(&VolumeView::update));
    connect(&workspace.pieces(), &Pieces::looksChanged, this, &VolumeView::requestMovingFrame);
    connect(&workspace.seeds(), &PendingSeeds::changed, this, [this] { requestFrame(); });
    connect(
        &workspace.refinement(), &Refinement::lookChanged, this, &VolumeView::requestMovingFrame);
    connect(&workspace.refinement(), &Refinement::changed, this, [this] { requestFrame(); });
    connect(&workspace.chunks(), &Chunks::pictureChanged, this, &VolumeView::requestMovingFrame);
    connect(&workspace.seeds(), &PendingSeeds::ghostChanged, this, &VolumeView::requestMovingFrame);
    connect(&workspace.refinement(), &Refinement::shown, this, &VolumeView::flyTo);
    connect(&workspace.plane(), &CuttingPlane::changed, this, &VolumeView::requestMovingFrame);
    connect(&workspace.layerLooks(), &LayerLooks::changed, this, &VolumeView::requestMovingFrame);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            // A layer that is muted, or a piece by now, is not drawn in part.
            const bool layers = change.what == core::DocumentChange::What::Layers
                || change.what == core::DocumentChange::What::Pieces;
            if (layers && !this->workspace().layerLooks().looks().empty())
                requestMovingFrame();
        });
    connect(&workspace, &Workspace::windowLevelChanged, this, [this] {
        const auto now = std::get<gpu::VolumeScene>(scene());
        if (now.faceWindow == this->workspace().windowLevel() || now.plane)
            requestMovingFrame();
    });
    openVolume();
}

QString VolumeView::title() const
{
    return QStringLiteral("3D");
}

QColor VolumeView::barColour() const
{
    return theme::volume;
}

void VolumeView::openVolume()
{
    m_otherEye = {}; // of the last study; the first eye's next picture would be shown with it
    if (!workspace().volume())
        workspace().frames().forget(otherEye(viewId()));
    resetView();
}

void VolumeView::resetView()
{
    m_fitted = true;
    if (const core::Volume* volume = workspace().volume()) {
        m_camera = openingCamera(volume->geometry);
        fit();
    }
    requestFrame();
}

void VolumeView::fit()
{
    if (const core::Volume* volume = workspace().volume())
        m_camera.heightMm = fittingHeightMm(m_camera, volume->geometry, size());
}

void VolumeView::setCamera(const Camera& camera)
{
    m_camera = camera;
    m_fitted = false;
    requestFrame();
}

void VolumeView::fitCamera(const Camera& camera)
{
    resetView();
    m_camera.towardsViewer = camera.towardsViewer;
    m_camera.up = camera.up;
    fit();
    requestFrame();
}

void VolumeView::flyTo(const glm::dvec3& placeLps, const glm::dvec3& fromLps)
{
    m_fitted = false;
    m_camera.targetLps = placeLps;
    if (fromLps != glm::dvec3(0.0))
        m_camera.lookFrom(fromLps);
    requestFrame();
}

void VolumeView::lookFrom(const glm::dvec3& sideLps)
{
    m_camera.lookFrom(sideLps);
    requestFrame();
}

gpu::Scene VolumeView::scene() const
{
    gpu::VolumeScene scene = volumeScene(m_camera, workspace().volumeDisplay());
    if (m_stereo.mode != Stereo::Mode::Off)
        scene.eyeShiftMm = -eyeShiftMm();
    scene.clip = shownClip(workspace());
    scene.pieces = workspace().pieces().scene();
    scene.seeds = workspace().seeds().scene();
    scene.surface = workspace().refinement().scene();
    scene.bodiless = workspace().refinement().bodiless();
    scene.chunks = workspace().chunks().bodies();
    if (!scene.chunks && workspace().viewOptions().showSegments)
        scene.chunks = workspace().seeds().ghost().bodies;
    scene.plane = workspace().plane().scene();
    const std::optional<core::ClipPlane> above = workspace().plane().clip();
    if (above && scene.surface)
        scene.surface->clip = *above;
    const std::vector<gpu::ScenePiece> partlyHidden = workspace().layerLooks().scene();
    scene.pieces.insert(scene.pieces.end(), partlyHidden.begin(), partlyHidden.end());
    // Only where it shows: other colours of the slices are no other picture else.
    if (scene.mode == gpu::RenderMode::Mip)
        scene.mipColours = workspace().viewOptions().colours;
    // Nor is another grey scale of theirs.
    const bool shaded =
        scene.mode == gpu::RenderMode::Surface || scene.mode == gpu::RenderMode::Dvr;
    if (shaded && scene.cutFaces == gpu::CutFaces::GreyValues)
        scene.faceWindow = workspace().windowLevel();
    return scene;
}

double VolumeView::eyeShiftMm() const
{
    const double awayMm = glm::distance(m_camera.eyeLps(), m_camera.targetLps);
    const double shift = awayMm * std::tan(0.5 * glm::radians(m_stereo.eyesDegrees));
    return m_stereo.swapped ? -shift : shift;
}

void VolumeView::setStereo(const Stereo& stereo)
{
    if (stereo == m_stereo)
        return;
    m_stereo = stereo;
    if (m_stereo.mode == Stereo::Mode::Off) {
        workspace().frames().forget(otherEye(viewId()));
        m_otherEye = {};
    }
    requestMovingFrame();
    Q_EMIT stereoChanged();
}

void VolumeView::turn(double rightwards, double downwards)
{
    m_camera.orbit(rightwards, downwards);
    requestMovingFrame();
}

void VolumeView::moveCamera(const Camera& camera)
{
    const bool turnedOnly =
        camera.targetLps == m_camera.targetLps && camera.heightMm == m_camera.heightMm;
    m_fitted = m_fitted && turnedOnly;
    m_camera = camera;
    requestMovingFrame();
}

bool VolumeView::takes(gpu::ViewId view) const
{
    return ImageView::takes(view) || view == otherEye(viewId());
}

void VolumeView::takeFrame(const gpu::Frame& frame)
{
    if (frame.view != otherEye(viewId()))
        return ImageView::takeFrame(frame);
    if (m_stereo.mode == Stereo::Mode::Off)
        return;
    m_otherEye = imageOf(frame);
    update();
}

void VolumeView::requested(const gpu::FrameRequest& request)
{
    if (m_stereo.mode == Stereo::Mode::Off)
        return;
    gpu::FrameRequest right = request;
    right.view = otherEye(viewId());
    auto& scene = std::get<gpu::VolumeScene>(right.scene);
    scene.eyeShiftMm = -scene.eyeShiftMm;
    workspace().frames().request(std::move(right));
}

QImage VolumeView::onScreen(const QImage& picture) const
{
    return m_otherEye.isNull() ? picture : composed(m_stereo.mode, picture, m_otherEye);
}

bool VolumeView::takesOverlays() const
{
    return m_stereo.mode != Stereo::Mode::SideBySide;
}

void VolumeView::hideEvent(QHideEvent* event)
{
    ImageView::hideEvent(event);
    workspace().frames().forget(otherEye(viewId()));
    m_otherEye = {};
}

void VolumeView::resizeEvent(QResizeEvent* event)
{
    if (m_fitted)
        fit();
    placeSwitch();
    ImageView::resizeEvent(event);
}

/// Over the lines at the bottom left.
void VolumeView::placeSwitch()
{
    constexpr int bottomMargin = 12;
    constexpr int lineHeight = 17;
    const int lines = workspace().volume() ? int(bottomTexts().size()) : 1;
    m_switch->adjustSize();
    m_switch->move(
        theme::padding, height() - bottomMargin - lines * lineHeight - m_switch->height());
}

OrientationCube VolumeView::cube(const Camera& camera) const
{
    return {camera, QPointF(width() - 54.0, height() - 58.0), 40.0};
}

QString VolumeView::modeText() const
{
    const core::Volume& volume = *workspace().volume();
    const double span = volume.maximum - volume.minimum;
    const Workspace::VolumeDisplay& display = workspace().volumeDisplay();
    if (display.context == gpu::Context::Hidden) {
        const std::array<bool, 256> visible = workspace().segmentDisplay().visible;
        const bool any = std::find(visible.begin(), visible.end(), true) != visible.end();
        return any || workspace().refinement().surface() ? tr("segments only")
                                                         : tr("segments only: none is visible");
    }
    switch (display.mode) {
    case gpu::RenderMode::Surface:
        return tr("isosurface at %1").arg(valueText(display.surfaceThreshold, volume.unit, span));
    case gpu::RenderMode::Dvr:
        return tr("volume rendering");
    case gpu::RenderMode::Mip:
    case gpu::RenderMode::Xray:
        break;
    }
    const core::WindowLevel& window = display.*Workspace::greyWindow(display.mode);
    const QString what =
        display.mode == gpu::RenderMode::Mip ? tr("maximum intensity") : tr("X-ray, mean");
    return QStringLiteral("%1 · W %2  L %3")
        .arg(what, valueText(window.width, QString(), span),
            valueText(window.centre, volume.unit, span));
}

QStringList VolumeView::bottomTexts() const
{
    QStringList texts{modeText()};
    if (const QString caution = workspace().refinement().caution(); !caution.isEmpty())
        texts.append(caution);
    return texts;
}

QString VolumeView::qualityText() const
{
    const auto shown = quality();
    if (!shown || *shown == gpu::Frame::Quality::Coarse)
        return QStringLiteral("drawing …");
    return *shown == gpu::Frame::Quality::Full ? QStringLiteral("refining …") : tr("full quality");
}

void VolumeView::paintAnnotations(QPainter& painter, const ViewContext& shown)
{
    const core::Volume& volume = *workspace().volume();
    const Workspace::ViewOptions& options = workspace().viewOptions();
    const Camera camera = cameraOf(std::get<gpu::VolumeScene>(shown.scene));

    if (options.showCrosshair) {
        // It lies at the crosshair's depth, mostly inside the body: small, readable on any ground.
        const QPointF at = crosshairPixel();
        painter.save();
        for (const QPen& pen : {QPen(QColor(0, 0, 0, 150), 2.6), QPen(theme::accent, 1.2)}) {
            painter.setPen(pen);
            for (const QPointF& arm :
                {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
                painter.drawLine(at + arm * 5.0, at + arm * 10.0);
        }
        painter.restore();
    }
    if (const auto box = growBoxOf(workspace().growSettings(), volume.geometry))
        paintBox(painter, shown, *box, volume.geometry, theme::good);
    paintPieceBadges(painter, shown, workspace());
    paintMeasurements(painter, shown, workspace());
    paintEdgeLetters(painter, textRect(), camera.right(), -camera.up);

    CornerTexts texts;
    texts.title = title();
    texts.titleColour = barColour();
    if (options.showPatient)
        texts.topLeft = patientLines(volume.identity);
    texts.topRight = {
        qualityText(), studyText(volume.identity), seriesText(volume.identity), timeText(volume)};
    texts.bottomLeft = bottomTexts();
    paintCorners(painter, textRect(), texts);
    cube(camera).paint(painter);
}

} // namespace ui

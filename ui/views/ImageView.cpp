// SPDX-License-Identifier: Apache-2.0
#include "ui/views/ImageView.h"

#include "gpu/scene/WindowMapping.h"
#include "ui/base/Theme.h"
#include "ui/input/Tool.h"
#include "ui/overlays/Annotations.h"
#include "ui/overlays/CautionStrip.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr int restMilliseconds = 160;
/// A picture that is held for a shorter time than this does not blink.
constexpr int unchangedMilliseconds = 300;

/// Slices count in pixels: a scene of logical pixels is not one of device pixels.
gpu::Scene scaled(gpu::Scene scene, double mmFactor)
{
    if (auto* slice = std::get_if<gpu::SliceScene>(&scene))
        slice->mmPerPixel *= mmFactor;
    return scene;
}

/// Whether a slice that is cubic once nothing moves lies elsewhere than it did.
bool movesCubics(const gpu::Scene& before, const gpu::Scene& now)
{
    const auto* was = std::get_if<gpu::SliceScene>(&before);
    const auto* is = std::get_if<gpu::SliceScene>(&now);
    return was && is && is->interpolation == gpu::Interpolation::Cubic
        && is->slab.mode == gpu::SlabMode::Off
        && (is->centreLps != was->centreLps || is->rightLps != was->rightLps
            || is->downLps != was->downLps || is->mmPerPixel != was->mmPerPixel);
}

bool takesText(const QWidget* widget)
{
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget);
}

} // namespace

ImageView::ImageView(Workspace& workspace, gpu::ViewId view, QWidget* parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_view(view)
    , m_pointer(workspace, *this, *this)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setTabletTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, [this] { requestFrame(false); });
    m_penRest.setSingleShot(true);
    m_penRest.setInterval(restMilliseconds);
    connect(&m_penRest, &QTimer::timeout, this, [this] {
        m_penRests = true;
        requestFrame();
    });

    m_heldLong.setSingleShot(true);
    m_heldLong.setInterval(unchangedMilliseconds);
    connect(&m_heldLong, &QTimer::timeout, this, [this] { update(); });

    const auto refresh = [this] { requestFrame(); };
    connect(&m_workspace, &Workspace::crosshairChanged, this, refresh);
    connect(&m_workspace, &Workspace::windowLevelChanged, this, refresh);
    connect(&m_workspace, &Workspace::viewOptionsChanged, this, refresh);
    connect(&m_workspace, &Workspace::volumeDisplayChanged, this, refresh);
    connect(&m_workspace, &Workspace::activeSegmentChanged, this, refresh); // whose growth is shown
    connect(&m_workspace, &Workspace::atToleranceChanged, this, &ImageView::requestMovingFrame);
    connect(&m_workspace, &Workspace::documentChanged, this,
        [this](const core::DocumentChange& change) {
            requestFrame();
            if (change.what == core::DocumentChange::What::Measurements)
                update(); // the picture stays, what lies over it does not
        });
    connect(&m_workspace, &Workspace::measuredChanged, this, [this] { update(); });
    connect(&m_workspace, &Workspace::activeToolChanged, this, [this] { m_pointer.followTool(); });
    // Another study: what the tool showed under the pointer was for the one before.
    connect(&m_workspace, &Workspace::sessionChanged, this, [this] {
        m_pointer.takeToolAway();
        m_requested = false; // what draws may be new
        // Of the next volume a picture may be done before the workspace shows it, and is not taken.
        // The same request then has to draw it again.
        if (!m_workspace.volume())
            m_workspace.frames().forget(m_view);
    });
    connect(&m_workspace, &Workspace::cautionAcceptedChanged, this, [this] { update(); });
    qApp->installEventFilter(this); // proximity of a pen is told to the application alone
}

ImageView::~ImageView()
{
    m_workspace.frames().forget(m_view);
}

ViewContext ImageView::context() const
{
    return {m_view, scene(), QSizeF(size())};
}

ViewContext ImageView::shownContext() const
{
    if (m_picture.isNull())
        return context();
    return {m_view, scaled(m_pictureScene, double(m_picture.width()) / std::max(width(), 1)),
        QSizeF(size())};
}

QPointF ImageView::crosshairPixel() const
{
    return shownContext().toPixel(m_workspace.crosshairLps());
}

std::optional<gpu::Frame::Quality> ImageView::quality() const
{
    if (m_picture.isNull() || m_pictureScene != m_request.scene
        || m_picture.size() != QSize(m_request.sizePixels.x, m_request.sizePixels.y))
        return std::nullopt;
    return m_pictureQuality;
}

QImage ImageView::imageOf(const gpu::Frame& frame)
{
    const qsizetype bytes = qsizetype(frame.sizePixels.x) * frame.sizePixels.y * 4;
    if (!frame.rgba || qsizetype(frame.rgba->size()) != bytes)
        return {};
    auto* keep = new std::shared_ptr<const std::vector<std::uint8_t>>(frame.rgba);
    return QImage(
        frame.rgba->data(), frame.sizePixels.x, frame.sizePixels.y, frame.sizePixels.x * 4,
        QImage::Format_RGBX8888,
        [](void* kept) {
            delete static_cast<std::shared_ptr<const std::vector<std::uint8_t>>*>(kept);
        },
        keep);
}

void ImageView::takeFrame(const gpu::Frame& frame)
{
    const QImage picture = imageOf(frame);
    if (!m_workspace.volume() || picture.isNull())
        return;
    m_picture = picture;
    m_pictureScene = frame.scene;
    m_pictureQuality = frame.quality;
    // A coarse picture may still be of the place where the view stood as the study was opened.
    if (frame.scene == m_request.scene || frame.quality != gpu::Frame::Quality::Coarse)
        releasePicture();
    update();
    Q_EMIT qualityChanged();
}

void ImageView::takeFailure()
{
    m_requested = false;
    releasePicture();
}

void ImageView::holdPicture(const QString& awaited)
{
    m_awaited = awaited;
    if (holdsPicture() || m_picture.isNull() || !isVisible())
        return;
    QPixmap held(sizeInDevicePixels());
    held.setDevicePixelRatio(devicePixelRatioF());
    // What lies in the view as a widget stays itself.
    render(&held, {}, {}, DrawWindowBackground);
    m_held = held;
    m_heldLong.start();
}

void ImageView::releasePicture()
{
    m_heldLong.stop();
    m_held = {};
    update();
}

void ImageView::setCoveredTop(int pixels)
{
    if (m_coveredTop == pixels)
        return;
    m_coveredTop = pixels;
    update();
}

void ImageView::paintHeld(QPainter& painter) const
{
    painter.drawPixmap(rect(), m_held);
    if (m_heldLong.isActive())
        return;
    QColor veil = theme::picture;
    veil.setAlpha(130);
    painter.fillRect(rect().adjusted(0, theme::viewBarHeight, 0, 0), veil);
    painter.setFont(theme::bodyFont());
    paintText(painter, rect().adjusted(theme::padding, 0, -theme::padding, 0),
        Qt::AlignCenter | Qt::TextWordWrap, m_awaited, theme::text);
}

void ImageView::showEarlySlice(const std::shared_ptr<const core::EarlySlice>& early)
{
    if (m_early == early)
        return;
    m_early = early;
    if (!m_workspace.volume())
        earlySliceChanged();
}

const core::EarlySlice* ImageView::early() const
{
    return m_workspace.volume() ? nullptr : m_early.get();
}

const core::Volume* ImageView::shownVolume() const
{
    return early() ? &early()->volume : m_workspace.volume();
}

QSize ImageView::sizeInDevicePixels() const
{
    const double ratio = devicePixelRatioF();
    return {int(width() * ratio), int(height() * ratio)};
}

void ImageView::drawWithoutEngine()
{
    m_picture = {};
    if (!early() || !isVisible())
        return;
    m_pictureScene = scaled(scene(), 1.0 / devicePixelRatioF());
    m_picture = earlyPictureOf(m_pictureScene, sizeInDevicePixels());
    m_pictureQuality.reset();
}

bool ImageView::activateSegmentUnderPointer()
{
    const std::optional<QPointF> at = m_pointer.position();
    if (!at || !isVisible())
        return false;
    activateSegmentAt(*at);
    return true;
}

void ImageView::requestFrame(bool interacting)
{
    update();
    if (!m_workspace.volume())
        return drawWithoutEngine();
    // Under a pointer at rest is another place once the picture has moved.
    if (const auto& at = m_pointer.position();
        at && context().isSlice() && rect().contains(at->toPoint()))
        m_workspace.setPointedLps(context().toLps(*at));
    if (!isVisible() || width() <= 0 || height() <= 0)
        return;
    gpu::FrameRequest request;
    request.view = m_view;
    request.sizePixels = {sizeInDevicePixels().width(), sizeInDevicePixels().height()};
    request.scene = scaled(scene(), 1.0 / devicePixelRatioF());
    request.segments = segmentDisplay();
    // Bodies have neither fill nor outline: their picture need not be drawn again for these.
    if (const auto* volume = std::get_if<gpu::VolumeScene>(&request.scene);
        volume && !volume->plane) {
        const gpu::SegmentDisplay usual;
        request.segments.fillOpacity = usual.fillOpacity;
        request.segments.outlineWidthPixels = usual.outlineWidthPixels;
    } else if (!volume) {
        request.segments.voxelTrue = false; // slices have no bodies
        request.segments.suspendedBodies = false;
    }
    // Else each turn of the wheel would be seen in two ways.
    if (m_requested && movesCubics(m_request.scene, request.scene))
        m_rest.start();
    request.interacting = interacting || m_rest.isActive() || (m_pointer.isAtWork() && !m_penRests);
    const bool same = m_requested && request.sizePixels == m_request.sizePixels
        && request.scene == m_request.scene && request.segments == m_request.segments
        && request.interacting == m_request.interacting;
    if (same)
        return;
    m_request = request;
    m_requested = true;
    m_workspace.frames().request(std::move(request));
    requested(m_request);
    Q_EMIT qualityChanged();
}

void ImageView::requestMovingFrame()
{
    m_rest.start();
    requestFrame(true);
}

core::WindowLevel ImageView::windowAfterDrag(
    const core::VoxelEncoding& encoding, core::WindowLevel window, const QPointF& moved)
{
    // The width moves in proportion to itself, so that narrow windows can be set finely.
    const double step = std::max(window.width, gpu::valuesApart(encoding)) / 250.0;
    window.width = std::max(window.width + moved.x() * step, gpu::leastWindowWidth(encoding));
    window.centre += moved.y() * step;
    return window;
}

bool ImageView::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == qApp && event->type() == QEvent::TabletLeaveProximity)
        m_pointer.endStrokeWithoutPen();
    return QWidget::eventFilter(watched, event);
}

bool ImageView::event(QEvent* event)
{
    switch (event->type()) {
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        m_penRests = false;
        m_pointer.handle(*event);
        // Whoever holds the pen still sees what it does in full quality.
        if (m_pointer.isAtWork())
            m_penRest.start();
        else
            m_penRest.stop();
        return true;
    case QEvent::WindowDeactivate:
        // Another window takes the pointer; whether the release will ever come is not known.
        m_pointer.loseStroke();
        m_pointer.forgetKeys();
        break;
    case QEvent::FocusOut:
        m_pointer.forgetKeys();
        break;
    case QEvent::ShortcutOverride:
        // What is under the pen goes before what the window would abort (SegmentWorkWatch).
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && m_pointer.takesEscape()) {
            event->accept();
            return true;
        }
        break;
    default:
        break;
    }
    return QWidget::event(event);
}

void ImageView::addViewEntries(QMenu& menu)
{
    menu.addSeparator();
    QAction* reset = menu.addAction(tr("Reset this view"), this, [this] { resetView(); });
    reset->setObjectName(QStringLiteral("resetThisView"));
    for (const auto& more : m_menuEnds)
        more(menu);
}

void ImageView::wheelEvent(QWheelEvent* event)
{
    m_pointer.turnWheel(*event);
}

void ImageView::enterEvent(QEnterEvent* event)
{
    QWidget::enterEvent(event);
    // Keys go to the picture under the pointer, but never out of a field that is being typed in.
    if (!takesText(QApplication::focusWidget()))
        setFocus(Qt::MouseFocusReason);
}

void ImageView::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    m_pointer.leave();
    update();
}

void ImageView::keyPressEvent(QKeyEvent* event)
{
    if (!m_pointer.pressKey(*event))
        QWidget::keyPressEvent(event);
}

bool ImageView::focusNextPrevChild(bool next)
{
    return (next && m_workspace.volume() && m_workspace.takeToolBefore())
        || QWidget::focusNextPrevChild(next);
}

void ImageView::keyReleaseEvent(QKeyEvent* event)
{
    if (!m_pointer.releaseKey(*event))
        QWidget::keyReleaseEvent(event);
}

void ImageView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    requestFrame();
}

void ImageView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    requestFrame();
}

void ImageView::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_pointer.forget();
    releasePicture(); // the next one will not come
    // Nobody looks: edits shall not draw this view anew.
    m_requested = false;
    m_workspace.frames().forget(m_view);
}

void ImageView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    if (holdsPicture())
        return paintHeld(painter);
    painter.fillRect(rect(), theme::picture);
    if (!m_picture.isNull() && shownVolume()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRectF(rect()), onScreen(m_picture));
    }
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    if (const core::Volume* volume = m_workspace.volume(); volume && takesOverlays()) {
        const ViewContext shown = shownContext();
        paintAnnotations(painter, shown);
        // Over them: what is said at the cursor is never hidden.
        if (Tool* tool = m_pointer.toolIn(shown)) {
            painter.save();
            tool->paintOverlay(painter, shown);
            painter.restore();
        }
        paintOnTop(painter);
        if (volume->needsCaution() && !m_workspace.cautionAccepted())
            paintCautionStrip(painter, textRect(), *volume);
    } else if (m_early && m_picture.isNull()) {
        paintCorners(painter, textRect(),
            {.title = title(),
                .titleColour = barColour(),
                .topLeft = {},
                .topRight = {},
                .bottomLeft = {},
                .bottomRight = {}});
        painter.setPen(theme::secondary);
        painter.drawText(rect(), Qt::AlignCenter, tr("Comes when all slices are there"));
    } else if (m_early) {
        paintAnnotations(painter, shownContext());
        if (m_early->volume.needsCaution())
            paintCautionStrip(painter, textRect(), m_early->volume);
    }
    painter.fillRect(QRect(0, 0, width(), theme::viewBarHeight), barColour());
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/encoding/EarlySlice.h"
#include "ui/geometry/ViewContext.h"
#include "ui/input/EveryPointerEvent.h"
#include "ui/input/StylusGlue.h"
#include "ui/workspace/Workspace.h"

#include <QImage>
#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

namespace ui {

/// A picture of the open volume with what is written over it. Asks for frames at device pixels,
/// shows the last finished one and lays overlays over exactly what that frame shows.
///
/// Pointer: the left button and the pen belong to the active tool where it works; otherwise, and
/// for the other buttons, the view navigates (UX §4.3).
///
/// While a study is on its way, a view that looks at the slice that is there already shows it, as
/// the engine will; the others say that they wait.
class ImageView : public QWidget {
    Q_OBJECT

public:
    ImageView(Workspace& workspace, gpu::ViewId view, QWidget* parent = nullptr);
    ~ImageView() override;

    [[nodiscard]] gpu::ViewId viewId() const { return m_view; }
    [[nodiscard]] virtual QString title() const = 0;
    [[nodiscard]] virtual QColor barColour() const = 0;

    /// What the user has asked to see, in logical pixels.
    [[nodiscard]] ViewContext context() const;
    /// What the picture on the screen shows; the same once the engine has caught up.
    [[nodiscard]] ViewContext shownContext() const;
    /// Where the crosshair is drawn.
    [[nodiscard]] QPointF crosshairPixel() const;
    [[nodiscard]] const QImage& picture() const { return m_picture; }
    /// None until there is a picture of what is asked for.
    [[nodiscard]] std::optional<gpu::Frame::Quality> quality() const;

    /// Whether frames of that name are this view's.
    [[nodiscard]] virtual bool takes(gpu::ViewId view) const { return view == m_view; }
    virtual void takeFrame(const gpu::Frame& frame);
    /// Null: no study is on its way, or nothing of it is there yet.
    void showEarlySlice(const std::shared_ptr<const core::EarlySlice>& early);
    /// Zoom, pan and camera back to the whole volume.
    virtual void resetView() = 0;

Q_SIGNALS:
    void maximiseToggled();
    void qualityChanged();

protected:
    /// What a drag does.
    enum class Gesture { None, Tool, Window, Pan, Zoom, Rotate };

    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    /// Null where a volume is open, or none is on its way.
    [[nodiscard]] const core::EarlySlice* early() const;
    /// The open volume, or that of the early slice, or null.
    [[nodiscard]] const core::Volume* shownVolume() const;
    [[nodiscard]] bool penOverPicture() const { return m_pointer.has_value(); }
    /// The scene in logical pixels.
    [[nodiscard]] virtual gpu::Scene scene() const = 0;
    [[nodiscard]] virtual Gesture gestureFor(Qt::MouseButton button, bool toolWorksHere) const = 0;
    virtual void dragged(Gesture gesture, const QPointF& from, const QPointF& to) = 0;
    /// A left click without a drag and without a tool.
    virtual void clicked(const QPointF&) { }
    /// Moved with no button down.
    virtual void hovered(const PointerSample&) { }
    virtual void wheelTurned(double steps, const QPointF& at, Qt::KeyboardModifiers modifiers) = 0;
    virtual void paintAnnotations(QPainter& painter, const ViewContext& shown) = 0;
    /// Of early(), for scene(); null where this view does not look at it.
    [[nodiscard]] virtual QImage earlyPictureOf(const gpu::Scene&, const QSize&) const
    {
        return {};
    }
    /// What early() says has changed.
    virtual void earlySliceChanged() { resetView(); }

    /// What has just been asked for, in device pixels.
    virtual void requested(const gpu::FrameRequest&) { }
    /// The picture as it comes onto the screen, and whether what lies over it can be laid there.
    [[nodiscard]] virtual QImage onScreen(const QImage& picture) const { return picture; }
    [[nodiscard]] virtual bool takesOverlays() const { return true; }
    /// Its bytes live as long as the image.
    [[nodiscard]] static QImage imageOf(const gpu::Frame& frame);

    /// Ask for a frame of scene() if it is not what was asked for last.
    void requestFrame(bool interacting = false);
    /// The same while something turns or moves; full quality follows when it rests.
    void requestMovingFrame();
    /// Rightwards is wider, downwards is higher.
    [[nodiscard]] static core::WindowLevel windowAfterDrag(
        core::WindowLevel window, const QPointF& moved);

    bool eventFilter(QObject* watched, QEvent* event) override;
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    void drawWithoutEngine();
    [[nodiscard]] QSize sizeInDevicePixels() const;
    bool handlePointer(QEvent& event);
    void pointerPressed(const PointerReading& reading);
    void pointerMoved(const PointerReading& reading);
    void pointerReleased(const PointerReading& reading);
    [[nodiscard]] bool toolWorksHere() const;
    void followTool();
    /// The pointer was taken away while a tool was at work.
    void loseStroke();
    void takeToolAway();
    void endStrokeWithoutPen();

    Workspace& m_workspace;
    gpu::ViewId m_view;
    StylusGlue m_glue;
    std::optional<EveryPointerEvent> m_everyEvent; ///< while a tool is at work
    PointerSample m_lastSample; ///< of the stroke

    gpu::FrameRequest m_request; ///< the last one
    bool m_requested = false;
    std::shared_ptr<const core::EarlySlice> m_early;
    QImage m_picture;
    gpu::Scene m_pictureScene; ///< in device pixels, as it came
    std::optional<gpu::Frame::Quality> m_pictureQuality; ///< none: the engine did not draw it
    QTimer m_rest;

    Gesture m_gesture = Gesture::None;
    Qt::MouseButton m_gestureButton = Qt::NoButton;
    QPointF m_pressedAt;
    QPointF m_lastAt;
    std::optional<glm::dvec3> m_crosshairBeforePressLps;
    bool m_dragging = false; ///< moved farther than a click does
    bool m_navigateKey = false; ///< Space: the left button navigates with a tool in hand
    bool m_toolIsHere = false; ///< it was told of the pointer here, and not that it left
    std::optional<QPointF> m_pointer; ///< over this view
    QPointer<Tool> m_tool; ///< the window may outlive it
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/encoding/EarlySlice.h"
#include "ui/geometry/ViewContext.h"
#include "ui/views/ViewPointer.h"
#include "ui/workspace/Workspace.h"

#include <QImage>
#include <QPixmap>
#include <QString>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QMenu;

namespace ui {

/// A view: a picture of the open volume with annotations over it. It requests frames in device
/// pixels, shows the latest finished one and draws overlays exactly for what that frame shows. What
/// the pointer does is handled by ViewPointer.
///
/// While a study is being loaded, a view whose plane is the slice that has already arrived shows it
/// as the engine will; other views show that they wait.
class ImageView : public QWidget, protected PointedView {
    Q_OBJECT

public:
    ImageView(Workspace& workspace, gpu::ViewId view, QWidget* parent = nullptr);
    ~ImageView() override;

    [[nodiscard]] gpu::ViewId viewId() const { return m_view; }
    [[nodiscard]] virtual QString title() const = 0;
    [[nodiscard]] virtual QColor barColour() const = 0;

    /// The scene that the user wants to see, in logical pixels.
    [[nodiscard]] ViewContext context() const override;
    /// The scene of the picture on the screen; it equals context() once the engine has caught up.
    [[nodiscard]] ViewContext shownContext() const;
    /// Whether a stroke or a drag is going on here.
    [[nodiscard]] bool pointerIsAtWork() const { return m_pointer.isAtWork(); }
    /// Makes the segment that lies under the pointer the active one.
    /// @return whether the pointer is over this view
    bool activateSegmentUnderPointer();
    /// Where the crosshair is drawn.
    [[nodiscard]] QPointF crosshairPixel() const;
    [[nodiscard]] const QImage& picture() const { return m_picture; }
    /// The quality of the picture; none until there is a picture of the wanted scene.
    [[nodiscard]] std::optional<gpu::Frame::Quality> quality() const;

    /// Whether frames with that id belong to this view.
    [[nodiscard]] virtual bool takes(gpu::ViewId view) const { return view == m_view; }
    virtual void takeFrame(const gpu::Frame& frame);
    /// Notes that the requested picture will not come. The next request is sent even if it is for
    /// the same picture.
    void takeFailure();
    /// Sets the early slice; null if no study is being loaded, or none has arrived yet.
    void showEarlySlice(const std::shared_ptr<const core::EarlySlice>& early);
    /// Keeps what is on the screen, whatever study is closed or opened, until a picture of the next
    /// one arrives. Does nothing if nothing was drawn yet.
    /// @param awaited what is to come; shown over the picture, which is dimmed, if that takes long
    void holdPicture(const QString& awaited);
    void releasePicture();
    /// Sets how many pixels at the top of this view lie under something else: texts keep below.
    void setCoveredTop(int pixels);
    [[nodiscard]] int coveredTop() const { return m_coveredTop; }
    [[nodiscard]] bool holdsPicture() const { return !m_held.isNull(); }
    /// Resets zoom, pan and camera to show the whole volume.
    virtual void resetView() = 0;
    /// Adds a function that appends entries to the end of this view's context menus.
    void addToMenus(std::function<void(QMenu&)> more) { m_menuEnds.push_back(std::move(more)); }

Q_SIGNALS:
    void maximiseToggled();
    void qualityChanged();

protected:
    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    /// The early slice; null if a volume is open, or none is being loaded.
    [[nodiscard]] const core::EarlySlice* early() const;
    /// The open volume, or the volume of the early slice, or null.
    [[nodiscard]] const core::Volume* shownVolume() const;
    [[nodiscard]] bool penOverPicture() const { return m_pointer.position().has_value(); }
    /// Where the pointer is over this view; none if it is elsewhere.
    [[nodiscard]] const std::optional<QPointF>& pointedPixel() const
    {
        return m_pointer.position();
    }
    /// The scene in logical pixels.
    [[nodiscard]] virtual gpu::Scene scene() const = 0;
    /// How segments are drawn here.
    [[nodiscard]] virtual gpu::SegmentDisplay segmentDisplay() const
    {
        return m_workspace.segmentDisplay();
    }
    virtual void paintAnnotations(QPainter& painter, const ViewContext& shown) = 0;
    /// Where texts and letters have their place.
    [[nodiscard]] QRect textRect() const { return rect().adjusted(0, m_coveredTop, 0, 0); }
    /// Paints what lies over everything else, the tool's overlay too.
    virtual void paintOnTop(QPainter&) { }
    /// The picture of early() for scene(); null if the view's plane is another one.
    [[nodiscard]] virtual QImage earlyPictureOf(const gpu::Scene&, const QSize&) const
    {
        return {};
    }
    virtual void activateSegmentAt(const QPointF& at) = 0;
    /// Adds the menu entries about the view itself, and those of addToMenus().
    void addViewEntries(QMenu& menu);
    /// Called when early() has changed.
    virtual void earlySliceChanged() { resetView(); }

    /// Called with each request, in device pixels.
    virtual void requested(const gpu::FrameRequest&) { }
    /// The picture as it is shown on the screen, and whether overlays can be drawn on it.
    [[nodiscard]] virtual QImage onScreen(const QImage& picture) const { return picture; }
    [[nodiscard]] virtual bool takesOverlays() const { return true; }
    /// The frame as an image, which keeps the frame's bytes alive.
    [[nodiscard]] static QImage imageOf(const gpu::Frame& frame);

    /// Requests a frame of scene() if it differs from the last request.
    void requestFrame(bool interacting = false);
    /// The same while something turns or moves; full quality follows when it stops.
    void requestMovingFrame();
    /// The window after a drag: rightwards makes it wider, downwards makes its centre higher.
    [[nodiscard]] static core::WindowLevel windowAfterDrag(
        const core::VoxelEncoding& encoding, core::WindowLevel window, const QPointF& moved);

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
    /// The tab key takes the tool before; where there is none, and backwards, it leaves the view.
    bool focusNextPrevChild(bool next) override;

private:
    void doubleClicked() override { Q_EMIT maximiseToggled(); }
    void refresh() override { requestFrame(); }
    void drawWithoutEngine();
    void paintHeld(QPainter& painter) const;
    [[nodiscard]] QSize sizeInDevicePixels() const;

    Workspace& m_workspace;
    gpu::ViewId m_view;
    ViewPointer m_pointer;
    std::vector<std::function<void(QMenu&)>> m_menuEnds;

    gpu::FrameRequest m_request; ///< the latest request
    bool m_requested = false;
    std::shared_ptr<const core::EarlySlice> m_early;
    QImage m_picture;
    gpu::Scene m_pictureScene; ///< in device pixels, as it came
    std::optional<gpu::Frame::Quality> m_pictureQuality; ///< none if the engine did not draw it
    int m_coveredTop = 0;
    QPixmap m_held; ///< what was on the screen; null: no picture is held
    QString m_awaited; ///< of holdPicture()
    QTimer m_heldLong; ///< active while m_held is shown as it was
    QTimer m_rest;
    QTimer m_penRest; ///< restarted by each move of a pen that is down
    bool m_penRests = false; ///< the pen is down and has not moved for a moment
};

} // namespace ui

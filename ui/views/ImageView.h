// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/encoding/EarlySlice.h"
#include "ui/geometry/ViewContext.h"
#include "ui/views/ViewPointer.h"
#include "ui/workspace/Workspace.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

namespace ui {

/// A picture of the open volume with what is written over it. Asks for frames at device pixels,
/// shows the last finished one and lays overlays over exactly what that frame shows. What the
/// pointer does to it and to the tool is ViewPointer's.
///
/// While a study is on its way, a view that looks at the slice that is there already shows it, as
/// the engine will; the others say that they wait.
class ImageView : public QWidget, protected PointedView {
    Q_OBJECT

public:
    ImageView(Workspace& workspace, gpu::ViewId view, QWidget* parent = nullptr);
    ~ImageView() override;

    [[nodiscard]] gpu::ViewId viewId() const { return m_view; }
    [[nodiscard]] virtual QString title() const = 0;
    [[nodiscard]] virtual QColor barColour() const = 0;

    /// What the user has asked to see, in logical pixels.
    [[nodiscard]] ViewContext context() const override;
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
    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    /// Null where a volume is open, or none is on its way.
    [[nodiscard]] const core::EarlySlice* early() const;
    /// The open volume, or that of the early slice, or null.
    [[nodiscard]] const core::Volume* shownVolume() const;
    [[nodiscard]] bool penOverPicture() const { return m_pointer.position().has_value(); }
    /// The scene in logical pixels.
    [[nodiscard]] virtual gpu::Scene scene() const = 0;
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
    void doubleClicked() override { Q_EMIT maximiseToggled(); }
    void refresh() override { requestFrame(); }
    void drawWithoutEngine();
    [[nodiscard]] QSize sizeInDevicePixels() const;

    Workspace& m_workspace;
    gpu::ViewId m_view;
    ViewPointer m_pointer;

    gpu::FrameRequest m_request; ///< the last one
    bool m_requested = false;
    std::shared_ptr<const core::EarlySlice> m_early;
    QImage m_picture;
    gpu::Scene m_pictureScene; ///< in device pixels, as it came
    std::optional<gpu::Frame::Quality> m_pictureQuality; ///< none: the engine did not draw it
    QTimer m_rest;
};

} // namespace ui

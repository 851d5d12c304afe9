// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameSource.h"
#include "ui/geometry/ViewContext.h"

#include <QImage>
#include <QPointF>
#include <QSizeF>

#include <optional>

class QPainter;

namespace ui {

/// A round lens over a slice. The engine draws its content at a larger scale, in frames of its own;
/// until such a frame arrives, the view's picture is enlarged. It only shows: its centre is the
/// place under the pointer, and pointer actions apply to that place.
class Lens {
public:
    static constexpr double magnification = 3.0;
    static constexpr double diameterPixels = 200.0; ///< logical

    /// @param view the view over which it lies
    Lens(gpu::FrameSource& frames, gpu::ViewId view);
    ~Lens();
    Lens(const Lens&) = delete;
    Lens& operator=(const Lens&) = delete;

    /// The id under which a lens over a view requests its frames.
    [[nodiscard]] static gpu::ViewId nameOver(gpu::ViewId view);
    [[nodiscard]] gpu::ViewId viewId() const { return nameOver(m_overView); }
    [[nodiscard]] bool isShown() const { return m_at.has_value(); }

    /// Shows the lens at a place.
    /// @param at centre of the lens, logical pixels of the view
    /// @param view the slice, in logical pixels
    /// @param pixelRatio device pixels per logical pixel
    void lookAt(const QPointF& at, const ViewContext& view, const gpu::SegmentDisplay& segments,
        double pixelRatio);
    /// Hides the lens and drops its frames.
    void putAway();
    /// Takes a frame of the lens that has arrived.
    /// @param picture the frame as an image
    void take(const gpu::Frame& frame, const QImage& picture);

    /// Draws the lens.
    /// @param whole the picture that the view shows.
    /// @param view size of the view, logical pixels
    void paint(QPainter& painter, const QImage& whole, const QSizeF& view) const;

private:
    [[nodiscard]] bool isDrawn() const; ///< a frame of its own for the present place has arrived

    gpu::FrameSource& m_frames;
    gpu::ViewId m_overView;
    std::optional<QPointF> m_at; ///< logical pixels; none: the lens is hidden
    gpu::FrameRequest m_request;
    QImage m_picture;
    gpu::Scene m_pictureScene;
};

} // namespace ui

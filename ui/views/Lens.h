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

/// A round lens about a place in a slice. What lies there is drawn by the engine at the larger
/// scale, in frames of the lens's own; until such a frame comes, the view's picture is enlarged. It
/// only shows: the middle of the lens is the place, and what the pointer does is done there.
class Lens {
public:
    static constexpr double magnification = 3.0;
    static constexpr double diameterPixels = 200.0; ///< logical

    /// @param view the one over whose picture it lies
    Lens(gpu::FrameSource& frames, gpu::ViewId view);
    ~Lens();
    Lens(const Lens&) = delete;
    Lens& operator=(const Lens&) = delete;

    /// The name under which the frames of a lens over such a view are asked for.
    [[nodiscard]] static gpu::ViewId nameOver(gpu::ViewId view);
    [[nodiscard]] gpu::ViewId viewId() const { return nameOver(m_overView); }
    [[nodiscard]] bool isShown() const { return m_at.has_value(); }

    /// @param view what the slice shows, in logical pixels
    /// @param pixelRatio device pixels per logical pixel
    void lookAt(const QPointF& at, const ViewContext& view, const gpu::SegmentDisplay& segments,
        double pixelRatio);
    void putAway();
    /// @param picture the frame as an image
    void take(const gpu::Frame& frame, const QImage& picture);

    /// @param whole the picture that the view shows
    void paint(QPainter& painter, const QImage& whole, const QSizeF& view) const;

private:
    [[nodiscard]] bool isDrawn() const; ///< by a frame of its own

    gpu::FrameSource& m_frames;
    gpu::ViewId m_overView;
    std::optional<QPointF> m_at; ///< logical pixels; none: it is not shown
    gpu::FrameRequest m_request;
    QImage m_picture;
    gpu::Scene m_pictureScene;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "ui/geometry/ViewContext.h"

#include <QColor>
#include <QImage>
#include <QObject>
#include <QPoint>

#include <map>
#include <memory>
#include <optional>

class QPainter;

namespace core {
class ContourState;
struct VolumeGeometry;
} // namespace core

namespace ui {

/// Draws an evolving contour in slices: its outline in the tool's colour, voxels that the segment
/// would gain in the segment's colour, voxels that it would lose in red. Each pixel shows the voxel
/// nearest to it, also in oblique slices. Pictures are computed on a background thread, at most one
/// at a time for each view. While the contour moves, the previous picture stays until the next is
/// ready; a picture of another slice is not shown. GUI thread.
class ContourDrawing : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    using State = std::shared_ptr<const core::ContourState>;

    /// Drops all pictures, when there is no contour any more.
    void forget()
    {
        m_background.cancel();
        m_drawn.clear();
    }
    /// Draws the latest picture. If that belongs to another state or view, requests a new one;
    /// drawn() is emitted when it is ready.
    /// @param view shows a slice
    void paint(QPainter& painter, const ViewContext& view, const State& state,
        const core::VolumeGeometry& geometry, const QColor& segment);

    /// Computes a picture; pixels where nothing is drawn are transparent. Any thread.
    /// @param area part of the view, logical pixels
    /// @param ratio device pixels per logical pixel
    [[nodiscard]] static QImage picture(const QRect& area, double ratio, const ViewContext& view,
        const core::ContourState& state, const core::VolumeGeometry& geometry,
        const QColor& segment);

Q_SIGNALS:
    void drawn(); ///< a new picture is ready

private:
    /// What a picture is to show.
    struct Wish {
        ViewContext view;
        double ratio = 1.0;
        QColor segment;
        /// Weak, so that a picture keeps no state in memory.
        std::weak_ptr<const core::ContourState> state;
    };
    struct Drawn {
        std::optional<Wish> wish; ///< what the picture shows; none: there is no picture yet
        QPoint corner; ///< top left corner of the picture in the view, logical pixels
        QImage image; ///< null: the slice misses the contour
        core::Background::Task making;
    };
    std::map<gpu::ViewId, Drawn> m_drawn;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui

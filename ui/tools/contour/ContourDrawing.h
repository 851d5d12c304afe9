// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <QColor>
#include <QImage>
#include <QPoint>

#include <map>

class QPainter;

namespace core {
class ContourTrack;
struct VolumeGeometry;
} // namespace core

namespace ui {

/// Draws in slices what a contour has come to: its outline, what the segment would gain in its
/// colour, and what it would lose in red. Each pixel shows the nearest voxel, along the grid and in
/// oblique slices alike. What was drawn for a view is kept until something of it changes.
class ContourDrawing {
public:
    /// The contour has moved, or is another one.
    void forget() { m_drawn.clear(); }
    /// @param view a slice
    void paint(QPainter& painter, const ViewContext& view, const core::ContourTrack& track,
        const core::VolumeGeometry& geometry, const QColor& segment);

    /// The same as a picture, whose pixels are transparent where nothing is drawn.
    /// @param area of the view, logical pixels
    /// @param ratio device pixels of a logical one
    [[nodiscard]] static QImage picture(const QRect& area, double ratio, const ViewContext& view,
        const core::ContourTrack& track, const core::VolumeGeometry& geometry,
        const QColor& segment);

private:
    struct Drawn {
        gpu::Scene scene;
        QSizeF sizePixels;
        double ratio = 1.0;
        QColor segment;
        QPoint corner;
        QImage image; ///< null: the slice misses the contour
    };
    std::map<gpu::ViewId, Drawn> m_drawn;
};

} // namespace ui

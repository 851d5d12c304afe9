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

/// Draws in slices what a contour has come to: its outline, what the segment would gain in its
/// colour, and what it would lose in red. Each pixel shows the nearest voxel, along the grid and in
/// oblique slices alike. Each picture is worked out on another thread, one at a time for each view;
/// while the contour moves, the last one stays until the next is there. One of another slice is not
/// shown. GUI thread.
class ContourDrawing : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    using State = std::shared_ptr<const core::ContourState>;

    /// There is no contour any more.
    void forget()
    {
        m_background.cancel();
        m_drawn.clear();
    }
    /// Draws the picture that there is and, where it is not the right one, has another one made.
    /// @param view a slice
    void paint(QPainter& painter, const ViewContext& view, const State& state,
        const core::VolumeGeometry& geometry, const QColor& segment);

    /// The picture, whose pixels are transparent where nothing is drawn. Any thread.
    /// @param area of the view, logical pixels
    /// @param ratio device pixels of a logical one
    [[nodiscard]] static QImage picture(const QRect& area, double ratio, const ViewContext& view,
        const core::ContourState& state, const core::VolumeGeometry& geometry,
        const QColor& segment);

Q_SIGNALS:
    void drawn(); ///< another picture is there

private:
    /// What a picture shows.
    struct Wish {
        ViewContext view;
        double ratio = 1.0;
        QColor segment;
        std::weak_ptr<const core::ContourState> state; ///< a picture does not keep it
    };
    struct Drawn {
        std::optional<Wish> wish; ///< none: there is no picture yet
        QPoint corner;
        QImage image; ///< null: the slice misses the contour
        core::Background::Task making;
    };
    std::map<gpu::ViewId, Drawn> m_drawn;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui

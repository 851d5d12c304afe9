// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/volume/VolumeGeometry.h"
#include "ui/geometry/ViewContext.h"

#include <QColor>
#include <QImage>
#include <QObject>

#include <cstddef>
#include <map>
#include <memory>

class QPainter;

namespace core {
class ContourState;
}

namespace ui {

/// Draws the voxels of an evolving contour in the 3D view as a shaded, translucent surface that
/// nothing hides. Pictures are computed on a background thread, one at a time; while the contour
/// moves, the previous picture stays until the next is ready. GUI thread.
class ContourGhost : public QObject {
    Q_OBJECT

public:
    /// Contours whose box has more voxels are not drawn.
    static constexpr std::size_t mostVoxels = std::size_t(1) << 26;

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
    /// @param view shows a VolumeScene
    void paint(QPainter& painter, const ViewContext& view, const State& state,
        const core::VolumeGeometry& geometry, const QColor& segment);

    /// Computes the picture of a whole view, one pixel for each of its logical pixels. Any thread.
    [[nodiscard]] static QImage picture(const ViewContext& view, const core::ContourState& state,
        const core::VolumeGeometry& geometry, const QColor& segment);

Q_SIGNALS:
    void drawn(); ///< a new picture is ready

private:
    struct Drawn {
        /// Weak, so that a picture keeps no state in memory.
        std::weak_ptr<const core::ContourState> state;
        ViewContext view;
        QColor segment;
        QImage image; ///< null: none yet
    };
    std::map<gpu::ViewId, Drawn> m_drawn;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui

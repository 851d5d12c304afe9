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

/// Shows in the 3D view what a contour has come to: its voxels as a shaded, translucent surface,
/// drawn through whatever would hide it. Each picture is worked out on another thread, one at a
/// time; while the contour moves, the last one stays until the next is there. GUI thread.
class ContourGhost : public QObject {
    Q_OBJECT

public:
    /// Larger boxes are not shown.
    static constexpr std::size_t mostVoxels = std::size_t(1) << 26;

    using QObject::QObject;
    using State = std::shared_ptr<const core::ContourState>;

    /// There is no contour any more.
    void forget()
    {
        m_background.cancel();
        m_drawn.clear();
    }
    /// Draws the picture that there is and, where it is not the right one, has another one made.
    /// @param view of a VolumeScene
    void paint(QPainter& painter, const ViewContext& view, const State& state,
        const core::VolumeGeometry& geometry, const QColor& segment);

    /// The picture of a view, in its logical pixels. Any thread.
    [[nodiscard]] static QImage picture(const ViewContext& view, const core::ContourState& state,
        const core::VolumeGeometry& geometry, const QColor& segment);

Q_SIGNALS:
    void drawn(); ///< another picture is there

private:
    struct Drawn {
        std::weak_ptr<const core::ContourState> state; ///< a picture does not keep it
        ViewContext view;
        QColor segment;
        QImage image; ///< null: none yet
    };
    std::map<gpu::ViewId, Drawn> m_drawn;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"
#include "ui/tools/common/CurveSketch.h"

#include <QObject>

namespace ui {

class Workspace;

/// Draws the outline of a freehand mask on the 3D view: once it is wanted, the next drag is not a
/// stroke but draws the curve, which then becomes the mask of drill and laser. A curve that is too
/// small is refused with a message, and the next drag tries again.
class ToolMaskDrawing : public QObject {
    Q_OBJECT

public:
    explicit ToolMaskDrawing(Workspace& workspace, QObject* parent = nullptr);

    /// Whether the next press begins a curve: because the user asked for it, or because the mask is
    /// freehand and has no outline yet.
    [[nodiscard]] bool isWanted() const;
    void want(bool wanted);
    [[nodiscard]] bool drawing() const { return m_sketch.drawing(); }
    [[nodiscard]] QString hint() const;

    void press(const PointerSample& sample, const ViewContext& view);
    void drag(const PointerSample& sample, const ViewContext& view);
    void release(const PointerSample& sample, const ViewContext& view);
    /// Cancels. The mask stays as it was; a freehand mask without an outline returns to the
    /// previous shape.
    /// @return whether there was anything to cancel
    bool cancel();
    void drop(); ///< drops only the curve, because its view is gone

    void paint(QPainter& painter, const ViewContext& view, const QPointF& cursor) const;

Q_SIGNALS:
    void changed(); ///< isWanted() has changed

private:
    void follow();
    void take(const std::vector<glm::dvec2>& curveMm, double mmPerPixel);

    Workspace& m_workspace;
    CurveSketch m_sketch;
    PointerSample m_pen; ///< how the pen was held at pen-down
    bool m_asked = false;
    bool m_wasWanted = false; ///< isWanted() when changed() was last emitted
};

} // namespace ui

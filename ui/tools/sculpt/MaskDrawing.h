// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"
#include "ui/tools/common/CurveSketch.h"

#include <QObject>

namespace ui {

class Workspace;

/// The outline of a freehand mask, drawn on the 3D view: once it is wanted, the next drag is no
/// stroke but the curve, which from then on is the mask of drill and laser. What is too small is
/// refused in words, and the next drag tries again.
class MaskDrawing : public QObject {
    Q_OBJECT

public:
    explicit MaskDrawing(Workspace& workspace, QObject* parent = nullptr);

    /// Whether the next press begins a curve: that was asked for, or the mask is a freehand one and
    /// nothing is drawn yet.
    [[nodiscard]] bool isWanted() const;
    void want(bool wanted);
    [[nodiscard]] bool drawing() const { return m_sketch.drawing(); }
    [[nodiscard]] QString hint() const;

    void press(const PointerSample& sample, const ViewContext& view);
    void drag(const PointerSample& sample, const ViewContext& view);
    void release(const PointerSample& sample, const ViewContext& view);
    /// The mask stays as it was; a freehand one that was not drawn yet goes back to the shape
    /// before. @return whether there was anything to cancel
    bool cancel();
    void drop(); ///< the curve alone: its view is gone

    void paint(QPainter& painter, const ViewContext& view, const QPointF& cursor) const;

Q_SIGNALS:
    void changed(); ///< isWanted()

private:
    void follow();
    void take(const std::vector<glm::dvec2>& curveMm, double mmPerPixel);

    Workspace& m_workspace;
    CurveSketch m_sketch;
    PointerSample m_pen; ///< as it was held at pen-down
    bool m_asked = false;
    bool m_wasWanted = false; ///< as it was told last
};

} // namespace ui

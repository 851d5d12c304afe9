// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "ui/tools/aim/SurfacePreview.h"
#include "ui/tools/common/CursorTool.h"
#include "ui/tools/common/CurveSketch.h"
#include "ui/tools/common/PenPressure.h"

#include <vector>

namespace ui {

/// Base of the tools that cut inside a curve sketched on the 3D view (seed A §4.1): peel and
/// scissors. The curve is closed implicitly; with Ctrl, or the pen's eraser end, the tool restores.
/// Points are millimetres in the view plane, right of and above the target.
class OutlineTool : public CursorTool {
    Q_OBJECT

public:
    explicit OutlineTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString target() const override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

protected:
    struct Sketch {
        core::OrthographicView view;
        std::vector<glm::dvec2> polygonMm;
        bool restore = false;
        core::ClipHalfSpaces hidden{}; ///< what the view's clip region hides
    };
    /// Called when a curve was closed that is large enough to be intended.
    virtual void cut(const Sketch& sketch) = 0;
    /// Called when a new curve is begun.
    virtual void begin() { }
    /// Whether the part of the surface that a curve would remove is shown beforehand; taken()
    /// reduces the surface to that part.
    [[nodiscard]] virtual bool showsTaken() const { return false; }
    [[nodiscard]] virtual SurfacePatch taken(SurfacePatch surface) const { return surface; }
    /// The text at the cursor.
    [[nodiscard]] virtual QStringList lines() const = 0;

    /// Whether the depth follows the pressure of a pen that draws a curve.
    [[nodiscard]] virtual bool depthFollowsPressure() const { return false; }
    /// How hard the pen is pressed along the curve that is being drawn or, in cut(), was closed.
    [[nodiscard]] const StrokePressure& pressure() const { return m_pressure; }

    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    [[nodiscard]] double surfaceThreshold() const;
    /// Shows the cursor's text there.

private:
    Workspace& m_workspace;
    SurfacePreview m_preview;
    CurveSketch m_sketch;
    StrokePressure m_pressure;
    bool m_restores = false;
};

} // namespace ui

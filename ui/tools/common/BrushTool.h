// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "ui/tools/common/CursorTool.h"
#include "ui/workspace/Workspace.h"

#include <functional>
#include <memory>

namespace ui {

class SeenSurface;

/// Base of the brushes (paint, barrier, carve brush): a ball, disc, square or cube follows the pen,
/// on a slice along its plane and with sides as the view's, in the 3D view a ball along the visible
/// surface. Ctrl or the pen's eraser end inverts
/// it; its radius may follow the pressure of a pen. Each stroke is one edit; its effect is visible
/// while the pen is down, and cancel() takes it back.
class BrushTool : public CursorTool {
    Q_OBJECT

public:
    static constexpr double minimumRadiusMm = 0.5;
    static constexpr double maximumRadiusMm = 60.0;
    /// The radius after so many steps of the wheel or of [ ].
    [[nodiscard]] static double radiusAfter(double radiusMm, int steps);

    BrushTool(Workspace& workspace, Workspace::Brush brush, QObject* parent);
    ~BrushTool() override;

    [[nodiscard]] QString target() const override { return action(m_inverted); }
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    /// Takes back a stroke under the pen. A stroke whose pen was lifted stays, even if its place is
    /// not known yet.
    void cancel() override;
    /// Undo drops a stroke whose pen was lifted while its place is not known yet.
    [[nodiscard]] bool canTakeStepBack() const override;
    void takeStepBack() override { drop(); }
    [[nodiscard]] QString stepText() const override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void changeRadius(int steps) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

protected:
    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    [[nodiscard]] const Workspace::BrushSettings& settings() const;
    /// Whether its effects without and with Ctrl are exchanged.
    [[nodiscard]] virtual bool isTurned() const { return false; }
    /// "paints Liver", "erases Liver", or why it cannot.
    [[nodiscard]] virtual QString action(bool inverted) const = 0;
    /// Why no stroke can begin, as a sentence; empty: one can, as far as is known before it.
    [[nodiscard]] virtual QString whyNot(bool /*inverted*/) const { return {}; }
    /// Which voxels may change, in words; empty if all may.
    [[nodiscard]] virtual QString limits() const { return {}; }
    /// How it follows edges on slices, in words; empty if it does not.
    [[nodiscard]] virtual QString edges() const { return {}; }
    [[nodiscard]] virtual QColor colour() const = 0;
    /// Makes the edit of a stroke from its path.
    using StrokeMaker = std::function<core::Result<core::Edit>(const core::BrushPath& path)>;
    /// What makes the edit of a stroke that is drawn from now on. In the 3D view the path is known
    /// only later: the edit is for what is active, and with what is set, at the time of this call.
    [[nodiscard]] virtual StrokeMaker strokeMaker(bool inverted, const ViewContext& view) = 0;
    /// Whether it works on the surface of segments where the volume steps back for them.
    [[nodiscard]] virtual bool worksOnSegments() const { return false; }
    /// How far around its radius a stroke changes what the 3D view shows, mm.
    [[nodiscard]] virtual double reachMm() const = 0;

private:
    struct Stroke;
    /// Where the pen is aimed in a 3D view, and how firmly it is pressed.
    struct Aim {
        glm::dvec2 planeMm{0.0};
        double pressure = 1.0;
    };

    [[nodiscard]] bool isInverse(const PointerSample& sample) const;
    [[nodiscard]] static QString shapeText(core::BrushPath::Shape shape);
    [[nodiscard]] core::BrushPath pathIn(const ViewContext& view) const;
    /// What a stroke in a 3D view lies on.
    [[nodiscard]] SeenSurface surfaceIn(const gpu::VolumeScene& scene, bool inverted) const;
    /// In a 3D view: asks what is seen along the way to this point, then continues the stroke
    /// there.
    void askOnTheWay(const Aim& to);
    void follow(Stroke& stroke, const Aim& from, const Aim& to);
    void goTo(Stroke& stroke, const glm::dvec3& pointLps, bool lifted, double pressure);
    void finish(const std::shared_ptr<Stroke>& stroke);
    void drop();
    void showCursor(const PointerSample& sample, gpu::ViewId view);

    Workspace& m_workspace;
    Workspace::Brush m_brush;
    std::shared_ptr<Stroke> m_stroke; ///< set until the whole stroke was sent to the session
    bool m_inverted = false;
    double m_pressure = 1.0; ///< the share of the radius at the cursor
};

} // namespace ui

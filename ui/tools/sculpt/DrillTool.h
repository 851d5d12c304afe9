// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "ui/tools/aim/SurfacePreview.h"
#include "ui/tools/aim/SweepAim.h"
#include "ui/tools/common/CursorTool.h"
#include "ui/tools/sculpt/ToolMaskDrawing.h"
#include "ui/workspace/Workspace.h"

#include <QElapsedTimer>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace ui {

class DrillOptions;

/// Cuts into the sculpt layer where the pen presses on the 3D view (seed A §4.1, 4.2; DESIGN §5),
/// or fills it again: with Ctrl, or the pen's eraser end. The view of pen-down holds for the whole
/// stroke; the cut shows while the pen is down, and cancel() takes it back. In mode Rate a resting
/// pen goes deeper.
class DrillTool : public CursorTool {
    Q_OBJECT

public:
    explicit DrillTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    /// Undo drops a stroke whose pen was lifted while its place is not known yet.
    [[nodiscard]] bool canTakeStepBack() const override;
    void takeStepBack() override;
    [[nodiscard]] QString stepText() const override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    void changeRadius(int steps) override;
    void changeDepth(int steps) override;
    [[nodiscard]] bool turns() const override { return true; }
    void turn(int steps) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    /// The outline of a freehand mask: while it is wanted, a drag draws it and cuts nothing.
    [[nodiscard]] const ToolMaskDrawing& drawing() const { return m_drawing; }

    /// The edit that a stroke begun in this view stands for, without samples.
    [[nodiscard]] core::DrillStroke strokeIn(const ViewContext& view, bool restore = false) const;

protected:
    /// What a press begins.
    [[nodiscard]] virtual core::Edit editIn(const ViewContext& view, bool restore) const;
    /// Of the settings, the tool's own depth.
    [[nodiscard]] virtual double& depthIn(Workspace::DrillSettings& settings) const;
    /// Whether it goes in along the surface normal, whatever sweep is set.
    [[nodiscard]] virtual bool followsSurface() const { return false; }
    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    /// Options that show, and ask for, the drawing of an outline.
    [[nodiscard]] QWidget* connected(DrillOptions* options);

private:
    struct Aiming;
    [[nodiscard]] double depthMm() const;
    [[nodiscard]] bool aims() const;
    [[nodiscard]] std::vector<glm::dvec2> footprint(
        const PointerSample& sample, const ViewContext& view) const;
    void aim(const PointerSample& sample, const ViewContext& view);
    void takeAim(const SurfacePatch& surface);
    void drop();
    /// @param mode of the edit
    [[nodiscard]] bool begin(const core::Edit& edit, core::DrillMode mode);
    [[nodiscard]] bool paintFootprint(QPainter& painter, const ViewContext& view) const;
    [[nodiscard]] core::PenSample penSample(const PointerSample& sample) const;
    void showCursor(const PointerSample& sample, gpu::ViewId view);
    void extend(const PointerSample& sample);
    void rest();

    Workspace& m_workspace;
    ToolMaskDrawing m_drawing;
    std::optional<ViewContext> m_strokeView; ///< set while the pen is down
    std::shared_ptr<Aiming> m_aiming;
    std::optional<SweepAim> m_aim; ///< of the stroke
    SurfacePreview m_preview;
    double m_startSeconds = 0.0;
    double m_pressure = 0.0;
    PointerSample m_held; ///< how the pen is held: when it went down, or as it hovers
    bool m_restores = false; ///< the stroke, or what a press would do now
    core::PenSample m_lastSample; ///< what a resting pen goes on reporting
    QElapsedTimer m_sinceLastSample;
    QTimer m_resting; ///< mode Rate: reports that time passes
};

} // namespace ui

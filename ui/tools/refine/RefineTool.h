// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/Workspace.h"

#include <optional>

namespace ui {

/// Works on the surface that is being refined, with mouse or pen, in slices and in the 3D view:
/// marks what is thought of it, pushes, scrapes, drags, smooths it and draws it to edges
/// (Refinement::Settings). One edit a stroke, which is seen while the pen is down; cancel() takes
/// it back. For a template it draws contours on slices of any orientation, which make an edit when
/// they are taken.
///
/// On a slice the pen is where the tool is. In the 3D view the tool follows the surface as it was
/// at pen-down; the sphere's middle lies half its radius outside of it and pushes inwards, with
/// Ctrl inside and pushes outwards.
class RefineTool : public Tool {
    Q_OBJECT

public:
    static constexpr double minimumRadiusMm = 0.5;
    static constexpr double maximumRadiusMm = 100.0;

    explicit RefineTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    [[nodiscard]] bool takes(const PointerSample& sample, const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void putAway() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    void changeRadius(int steps) override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    struct Stroke {
        ViewContext view; ///< of pen-down; holds for the whole stroke
        core::SurfaceMirror surface; ///< as it was then
        Refinement::Settings settings;
        bool inverted = false;
        double depthMm = 0.0; ///< 3D: of what was hit last, along the view
        glm::dvec3 last{0.0}; ///< LPS
    };

    /// Where the tool is; none: the surface is not met.
    [[nodiscard]] std::optional<glm::dvec3> placeOf(Stroke& stroke, const QPointF& pixel) const;
    [[nodiscard]] std::optional<core::MeshHit> hitAt(
        const core::SurfaceMirror& surface, const ViewContext& view, const QPointF& pixel) const;
    [[nodiscard]] core::Edit editOf(const Stroke& stroke, const glm::dvec3& placeLps) const;
    [[nodiscard]] QColor colour() const;
    void endContour();
    void paintContours(QPainter& painter, const ViewContext& view) const;

    Workspace& m_workspace;
    std::optional<Stroke> m_stroke;
    /// The contour under the pen, LPS, and the view it is drawn in.
    struct Contour {
        ViewContext view;
        std::vector<glm::dvec3> pointsLps;
    };
    std::optional<Contour> m_contour;
    QPointF m_cursor;
    std::optional<gpu::ViewId> m_cursorView;
    bool m_inverted = false;
};

} // namespace ui

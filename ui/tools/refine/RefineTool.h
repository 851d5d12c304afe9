// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/CursorTool.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/Workspace.h"

#include <optional>

namespace ui {

/// Edits the surface that is being refined, with mouse or pen, in slices and in the 3D view: it
/// marks, pushes, scrapes, drags and smooths the surface, or draws it to edges
/// (Refinement::Settings). Each stroke is one edit, visible while the pen is down; cancel() takes
/// it back. For a template it draws contours on slices of any orientation, which become an edit
/// when they are applied.
///
/// On a slice the tool is at the pen. In the 3D view it follows the surface as it was at pen-down,
/// as far as it is seen: what clipping hides is not there.
/// The centre of the sphere then lies half its radius outside of the surface and pushes inwards;
/// with Ctrl it lies inside and pushes outwards. On a slice the sphere lies at the mirror image of
/// the pen about the surface with Ctrl, so that it pushes the other way there, too; and the scraper
/// fills up to its plane. With Ctrl, contours of the slice are rubbed out. Ctrl does nothing to
/// tools without an opposite.
///
/// Places are in the space that views show (ShownSurface.h) until they become part of an edit,
/// which has the true ones.
class RefineTool : public CursorTool {
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
    void changeRadius(int steps) override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    struct Stroke {
        ViewContext view; ///< the view at pen-down, used for the whole stroke
        core::SurfaceMirror surface; ///< the surface at pen-down
        Refinement::Settings settings;
        bool inverted = false;
        double depthMm = 0.0; ///< in a 3D view: depth of the last hit along the view
        glm::dvec3 last{0.0}; ///< LPS
        bool isPressed = false; ///< the radius follows the pressure
        double lastPressure = 1.0;
    };

    /// Where the tool is, LPS; none if the surface is not met.
    [[nodiscard]] std::optional<glm::dvec3> placeOf(
        Stroke& stroke, const PointerSample& sample) const;
    /// Whether Ctrl, or the pen's eraser end, is held where it does the opposite.
    [[nodiscard]] bool isInverse(const PointerSample& sample) const;
    /// What is seen of the surface at a pixel of the 3D view; its distance is along the view.
    [[nodiscard]] std::optional<core::MeshHit> hitAt(
        const core::SurfaceMirror& surface, const ViewContext& view, const QPointF& pixel) const;
    /// @param placeLps as views show it
    [[nodiscard]] core::Edit editOf(const Stroke& stroke, const glm::dvec3& placeLps) const;
    [[nodiscard]] QColor colour() const;
    void endContour();
    /// Takes away the contours between where the rubber is and another place.
    void rub(const QPointF& to);
    /// Whether a press under the pointer would rub contours out, or does.
    [[nodiscard]] bool isRubber() const
    {
        return m_inverted && m_workspace.refinement().settings().mode == Refinement::Mode::Template;
    }
    void paintContours(QPainter& painter, const ViewContext& view) const;

    Workspace& m_workspace;
    std::optional<Stroke> m_stroke;
    /// The contour that is being drawn, LPS, and the view in which it is drawn.
    struct Contour {
        ViewContext view;
        std::vector<glm::dvec3> pointsLps;
    };
    std::optional<Contour> m_contour;
    /// What takes contours of a slice away.
    struct Rubber {
        ViewContext view;
        QPointF at; ///< logical pixels
        bool hasMet = false; ///< whether it has met a contour so far
    };
    std::optional<Rubber> m_rubber;
    bool m_inverted = false;
    double m_pressure = 1.0; ///< the share of the radius at the cursor
};

} // namespace ui

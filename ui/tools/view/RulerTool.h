// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"

#include <optional>

namespace ui {

class Workspace;

/// Measures the distance between two points by a drag on a slice, or on what the 3D view shows.
/// Points on a piece are taken at their true place, so that the length is true however the piece
/// was moved or zoomed. Each measurement is one AddMeasurement, drawn in every view
/// (overlays/MeasurementLines.h).
class RulerTool : public Tool {
    Q_OBJECT

public:
    explicit RulerTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    /// The list of measurements, from which they can be removed.
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    void measureWhatIsSeen(const ViewContext& view);
    void keep(const glm::dvec3& fromLps, const glm::dvec3& toLps, int piece);

    Workspace& m_workspace;
    std::optional<ViewContext> m_pressedView; ///< the view of the press, used until the release
    QPointF m_from;
    QPointF m_to;
    QPointF m_cursor;
    std::optional<gpu::ViewId> m_cursorView;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"
#include "ui/tools/common/SliceOutline.h"

#include <QColor>

#include <optional>

namespace ui {

class Workspace;

/// Gives the active segment what lies inside an outline in one slice, along the grid or oblique;
/// with Ctrl or the pen's eraser end it takes it away. Each outline is one step. Which voxels may
/// change is set as for painting. The first outline of a session makes a segment, as a step of its
/// own.
class FillOutlineTool : public Tool {
    Q_OBJECT

public:
    using Shape = SliceOutline::Shape;

    explicit FillOutlineTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override { return action(m_erases); }
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override { return view.isSlice(); }

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    /// A corner of a polygon that is open.
    [[nodiscard]] bool canTakeStepBack() const override;
    void takeStepBack() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    bool pressKey(int key) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    [[nodiscard]] Shape shape() const { return m_shape; }
    /// An outline that is open is dropped.
    void setShape(Shape shape);

Q_SIGNALS:
    void shapeChanged();

private:
    [[nodiscard]] QString action(bool erases) const;
    [[nodiscard]] QColor colour() const;
    void drop();
    void pressCorner(const PointerSample& sample, const ViewContext& view);
    /// Fills what is drawn and ends the drawing. A polygon that cannot be filled stays open: it is
    /// more work than another stroke.
    void close(const ViewContext& view);
    void showCursor(const PointerSample& sample, const ViewContext& view);
    [[nodiscard]] static bool isInverse(const PointerSample& sample);

    Workspace& m_workspace;
    Shape m_shape = Shape::Lasso;
    SliceOutline m_outline;
    std::optional<ViewContext> m_view; ///< in which the open outline was pressed last
    bool m_pressed = false; ///< the button or pen that draws is down
    bool m_erases = false;
    QPointF m_cursor;
    std::optional<gpu::ViewId> m_cursorView;
};

} // namespace ui

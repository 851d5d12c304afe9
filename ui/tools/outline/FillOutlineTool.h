// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/CursorTool.h"
#include "ui/tools/common/SliceOutline.h"
#include "ui/tools/outline/LevelTrace.h"
#include "ui/tools/outline/LiveWire.h"
#include "ui/tools/outline/ReadSlice.h"

#include <QString>

#include <optional>

namespace ui {

class Workspace;

/// Fills an outline in one slice, also in an oblique one: the active segment gets the voxels inside
/// it, or loses them with Ctrl or the pen's eraser end. Each outline is one step. Which voxels may
/// change is set as for painting. If there is no segment, the first outline adds one, as a step of
/// its own.
///
/// Two shapes follow the picture: the livewire and the contour of a value. They are computed in the
/// background. An outline that is closed or clicked before its computation has ended is filled as
/// soon as it has, at the place that was meant.
class FillOutlineTool : public CursorTool {
    Q_OBJECT

public:
    using Shape = SliceOutline::Shape;

    explicit FillOutlineTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override { return view.isSlice(); }

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    /// Undo takes back the last corner of an open polygon or the last anchor of a livewire.
    [[nodiscard]] bool canTakeStepBack() const override;
    void takeStepBack() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    bool pressKey(int key) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    [[nodiscard]] Shape shape() const { return m_shape; }
    /// Chooses the shape. An open outline is dropped.
    void setShape(Shape shape);

Q_SIGNALS:
    void shapeChanged();

private:
    void drop();
    /// Whether the shape is made of clicks, so that it stays open after the button or pen is
    /// lifted.
    [[nodiscard]] bool isClicked() const;
    void pressCorner(const PointerSample& sample, const ViewContext& view);
    /// Passes the place of the pointer to the livewire or the contour of a value.
    void follow(const PointerSample& sample, const ViewContext& view);
    void showWire();
    void showLevel();
    /// Whether what is drawn is large enough to be intentional.
    [[nodiscard]] bool isMeant() const;
    [[nodiscard]] QString howToDraw() const;
    /// Fills the outline and ends the drawing. An outline made of clicks that cannot be filled
    /// stays open, since drawing it was more work than another stroke.
    void close();
    /// The same, if the computation that follows the picture has ended.
    void closeIfKnown();
    /// Gives up filling a closed outline that still waits, since the segment or the limits have
    /// changed or the computation has failed.
    void stopClosing();
    /// Whether the contour of the value has more corners than an edit takes. It is not drawn then.
    [[nodiscard]] bool isRagged() const;
    [[nodiscard]] QString levelText() const;
    [[nodiscard]] static bool isInverse(const PointerSample& sample);

    Workspace& m_workspace;
    Shape m_shape = Shape::Lasso;
    SliceOutline m_outline;
    std::optional<ViewContext> m_view; ///< the view of the last press in the open outline
    bool m_pressed = false; ///< the button or pen is down
    bool m_closes = false; ///< the outline is filled as soon as its computation has ended
    bool m_erases = false;
    ReadSlice m_slice; ///< the slice whose picture is followed
    LiveWire m_wire;
    LevelTrace m_level;
    std::optional<ViewContext> m_levelView; ///< the view in which the value was pointed at
    SliceOutline m_levelOutline; ///< the contour as it is drawn
};

} // namespace ui

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

/// Gives the active segment what lies inside an outline in one slice, along the grid or oblique;
/// with Ctrl or the pen's eraser end it takes it away. Each outline is one step. Which voxels may
/// change is set as for painting. The first outline of a session makes a segment, as a step of its
/// own.
///
/// Two shapes follow the picture: the livewire and the contour of a level. What they need is worked
/// out beside the window; one that is closed or clicked before that is filled as soon as it is
/// known, at the place that was meant.
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
    /// A corner of a polygon that is open, or an anchor of a wire.
    [[nodiscard]] bool canTakeStepBack() const override;
    void takeStepBack() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    bool pressKey(int key) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    [[nodiscard]] Shape shape() const { return m_shape; }
    /// An outline that is open is dropped.
    void setShape(Shape shape);

Q_SIGNALS:
    void shapeChanged();

private:
    void drop();
    /// Whether it is clicked together, and stays open after the button or pen is lifted.
    [[nodiscard]] bool isClicked() const;
    void pressCorner(const PointerSample& sample, const ViewContext& view);
    /// What follows the picture is told where the pointer is.
    void follow(const PointerSample& sample, const ViewContext& view);
    void showWire();
    void showLevel();
    /// Whether what is drawn can have been intended.
    [[nodiscard]] bool isMeant() const;
    [[nodiscard]] QString howToDraw() const;
    /// Fills what is drawn and ends the drawing. What is clicked together and cannot be filled
    /// stays open: it is more work than another stroke.
    void close();
    /// The same once the picture has been followed.
    void closeIfKnown();
    /// What was closed is not filled any more: it would be another's, or under other limits.
    void stopClosing();
    /// Whether the contour of the level has more corners than an edit takes. It is not drawn then.
    [[nodiscard]] bool isRagged() const;
    [[nodiscard]] QString levelText() const;
    [[nodiscard]] static bool isInverse(const PointerSample& sample);

    Workspace& m_workspace;
    Shape m_shape = Shape::Lasso;
    SliceOutline m_outline;
    std::optional<ViewContext> m_view; ///< in which the open outline was pressed last
    bool m_pressed = false; ///< the button or pen that draws is down
    bool m_closes = false; ///< it is filled as soon as the picture has been followed
    bool m_erases = false;
    ReadSlice m_slice; ///< in which the picture is followed
    LiveWire m_wire;
    LevelTrace m_level;
    std::optional<ViewContext> m_levelView; ///< in which the level was pointed at
    SliceOutline m_levelOutline; ///< the contour as it is shown
};

} // namespace ui

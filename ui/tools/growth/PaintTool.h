// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/BrushPath.h"
#include "ui/tools/common/BrushTool.h"

namespace ui {

/// Paints the active segment on slices and on the surface that the 3D view shows; with Ctrl or the
/// pen's eraser end it erases it. The first stroke of a session makes a segment, as an entry of its
/// own. What is painted takes part in growth where the segment has seeds.
class PaintTool : public BrushTool {
    Q_OBJECT

public:
    explicit PaintTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

protected:
    [[nodiscard]] QString action(bool inverted) const override;
    [[nodiscard]] QString limits() const override;
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] core::Result<core::Edit> strokeAlong(
        const core::BrushPath& path, bool inverted, const ViewContext& view) override;
    [[nodiscard]] double reachMm() const override { return 0.0; }
};

/// Whether a segment has seeds among the steps that stand: then growth goes on from it.
[[nodiscard]] bool takesPartInGrowth(const core::History& history, int segment);

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/BrushTool.h"

namespace ui {

/// Paints the active segment, on slices and on the visible surface of the 3D view; with Ctrl or the
/// pen's eraser end it erases. The first stroke of a session makes a segment, as a step of its own.
/// If the segment has seeds, painted voxels take part in its growth. On slices it may follow edges.
class PaintTool : public BrushTool {
    Q_OBJECT

public:
    explicit PaintTool(Workspace& workspace, QObject* parent = nullptr);

    /// Whether it is an eraser, which paints with Ctrl or the pen's eraser end.
    [[nodiscard]] bool erases() const { return m_erases; }
    void setErases(bool erases);
    bool endMode() override;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

protected:
    [[nodiscard]] bool isTurned() const override { return m_erases; }
    [[nodiscard]] QString action(bool inverted) const override;
    [[nodiscard]] QString whyNot(bool inverted) const override;
    [[nodiscard]] QString limits() const override;
    [[nodiscard]] QString edges() const override;
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] StrokeMaker strokeMaker(bool inverted, const ViewContext& view) override;
    [[nodiscard]] bool worksOnSegments() const override { return true; }
    [[nodiscard]] double reachMm() const override { return 0.0; }

private:
    bool m_erases = false;
};

/// Whether a segment has seeds among the present steps: then its growth goes on from what is
/// painted.
[[nodiscard]] bool takesPartInGrowth(const core::History& history, int segment);

} // namespace ui

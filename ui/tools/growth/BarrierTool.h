// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/BrushTool.h"

namespace ui {

/// Paints barriers that close voxels to growth, on slices and on the visible surface of the 3D
/// view; with Ctrl or the pen's eraser end it opens them again. Voxels that a growth has added
/// there are removed.
class BarrierTool : public BrushTool {
    Q_OBJECT

public:
    explicit BarrierTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

protected:
    [[nodiscard]] QString action(bool inverted) const override;
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] StrokeMaker strokeMaker(bool inverted, const ViewContext& view) override;
    [[nodiscard]] double reachMm() const override { return 0.0; }
};

} // namespace ui

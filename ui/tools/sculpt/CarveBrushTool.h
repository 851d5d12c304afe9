// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/BrushTool.h"

namespace ui {

/// Carves the active sculpt layer along the pen, on slices and along the surface that the 3D view
/// shows; with Ctrl or the pen's eraser end it restores what was carved.
class CarveBrushTool : public BrushTool {
    Q_OBJECT

public:
    explicit CarveBrushTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

protected:
    [[nodiscard]] QString action(bool inverted) const override;
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] StrokeMaker strokeMaker(bool inverted, const ViewContext& view) override;
    [[nodiscard]] double reachMm() const override;
};

} // namespace ui

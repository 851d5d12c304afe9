// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/sculpt/DrillTool.h"

namespace ui {

/// A drill whose mask is perpendicular to the surface normal under the pen and goes in along that
/// normal (seed A §4.3; DESIGN §5). It shares the drill's mask and has a depth of its own.
class LaserTool final : public DrillTool {
    Q_OBJECT

public:
    using DrillTool::DrillTool;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

protected:
    [[nodiscard]] core::Edit editIn(const ViewContext& view, bool restore) const override;
    [[nodiscard]] double& depthIn(Workspace::DrillSettings& settings) const override;
    [[nodiscard]] bool followsSurface() const override { return true; }
};

} // namespace ui

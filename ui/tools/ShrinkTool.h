// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/SketchTool.h"

namespace ui {

/// Takes back what grew through the sketched places (core::ShrinkAt): cut off at its narrowest
/// passage, which is shut; with Ctrl only the sketched voxels.
class ShrinkTool : public SketchTool {
    Q_OBJECT

public:
    using SketchTool::SketchTool;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;

private:
    void commit(const std::vector<glm::ivec3>& voxels) override;
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] QString outsideText() const override;
    [[nodiscard]] QString nothingSeenText() const override;
};

} // namespace ui

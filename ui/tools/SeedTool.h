// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/SketchTool.h"

namespace ui {

/// Sketches seeds of the active segment (seed A §5.1). One SeedStroke per sketch; the first sketch
/// of a session makes a segment, as an entry of its own.
class SeedTool : public SketchTool {
    Q_OBJECT

public:
    explicit SeedTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    void commit(const std::vector<glm::ivec3>& voxels) override;
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] QString outsideText() const override;
    [[nodiscard]] QString nothingSeenText() const override;
};

} // namespace ui

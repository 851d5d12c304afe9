// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "ui/tools/common/SketchTool.h"

namespace ui {

/// Sketches seeds of the active segment (seed A §5.1). Each sketch is one SeedStroke; the first
/// sketch of a session makes a segment, as a step of its own. With Ctrl, or the pen's eraser end,
/// it removes seeds under the path that no growth has accepted, of any segment; with Shift it moves
/// the one under the pointer. On request a pen's pressure is how wide it sketches.
class SeedTool : public SketchTool {
    Q_OBJECT

public:
    explicit SeedTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    bool finishOtherwise(const std::vector<glm::dvec2>& pixels, const ViewContext& view) override;
    void commit(const std::vector<glm::ivec3>& voxels) override;
    [[nodiscard]] bool takesAway() const;
    [[nodiscard]] bool moves() const;
    void takeAway(const std::vector<glm::dvec2>& pixels, const ViewContext& view);
    void move(const glm::dvec2& from, const glm::dvec2& to, const ViewContext& view);
    void apply(const core::SeedStroke& stroke, const QString& done);
    /// Tells the user the result of a stroke.
    void reportSeeds(const core::SeedStroke& stroke, const QString& done);
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] QString outsideText() const override;
    [[nodiscard]] QString nothingSeenText() const override;
};

} // namespace ui

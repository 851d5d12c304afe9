// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/SketchTool.h"

namespace ui {

class ShrinkPreview;
class SketchedVoxels;

/// Takes back the sketched voxels and what grew through them (core::ShrinkAt). The growth is cut at
/// its narrowest passage, or half-way to the seeds, and closed there; with Ctrl only the sketched
/// voxels are removed. While the pen is down the tool shows what would be removed.
class ShrinkTool : public SketchTool {
    Q_OBJECT

public:
    explicit ShrinkTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;

    [[nodiscard]] const ShrinkPreview& preview() const { return *m_preview; }

private:
    void sketchBegan(const ViewContext& view) override;
    void sketchGrew(const std::vector<glm::dvec2>& pixels) override;
    void sketchOver() override;
    [[nodiscard]] QStringList cursorLines() const override;
    void commit(const std::vector<glm::ivec3>& voxels) override;
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] QString outsideText() const override;
    [[nodiscard]] QString nothingSeenText() const override;

    SketchedVoxels* m_sketched;
    ShrinkPreview* m_preview;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/SketchTool.h"

#include <QTimer>

#include <cstddef>
#include <optional>
#include <vector>

namespace ui {

class HeldShrink;
class ShrinkPreview;

/// Takes back the sketched voxels and what grew through them (core::ShrinkAt). The growth is cut at
/// its narrowest passage, or half-way to the seeds, and closed there; with Ctrl or the pen's eraser
/// end only the sketched voxels are removed. While the pen is down the tool shows what would be
/// removed. Where the pen rests after that, the growth is taken back from the sketch, generation by
/// generation, until it is lifted (HeldShrink).
class ShrinkTool : public SketchTool {
    Q_OBJECT

public:
    explicit ShrinkTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

    [[nodiscard]] const ShrinkPreview& preview() const { return *m_preview; }
    /// Whether the preview covers the whole sketch so far. In the 3D view the voxels under a sketch
    /// are found out piece by piece.
    [[nodiscard]] bool previewIsWhole() const;
    [[nodiscard]] const HeldShrink& held() const { return *m_held; }
    /// Sets how long the pen must rest before the growth goes back; 700 ms at first.
    void setRest(int milliseconds) { m_rest.setInterval(milliseconds); }

private:
    void sketchBegan(const ViewContext& view) override;
    void sketchGrew(const SketchPath& path) override;
    void sketchOver() override;
    bool finishOtherwise(const std::vector<glm::dvec2>& pixels, const ViewContext& view) override;
    [[nodiscard]] QStringList cursorLines() const override;
    void commit(const std::vector<glm::ivec3>& voxels) override;
    [[nodiscard]] QColor colour() const override;
    [[nodiscard]] QString outsideText() const override;
    [[nodiscard]] QString nothingSeenText() const override;

    void rest();
    void reportLastRow(std::size_t rowsBefore);

    SketchedVoxels* m_sketched;
    ShrinkPreview* m_preview;
    HeldShrink* m_held;
    QTimer m_rest; ///< runs from the pen's last move, or from the moment when the preview is known
    std::optional<glm::dvec2> m_restsAt; ///< pixel
};

} // namespace ui

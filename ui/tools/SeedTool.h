// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/Tool.h"

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Sketches seeds of the active segment (seed A §5.1): on a slice the voxels under the path, on the
/// 3D view the voxels that are seen under it. One SeedStroke per sketch; the first sketch of a
/// session makes a segment, as an entry of its own.
class SeedTool : public Tool {
    Q_OBJECT

public:
    explicit SeedTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    void commitOnSlice();
    void askWhatIsSeen();
    void commit(const std::vector<glm::ivec3>& voxels);

    Workspace& m_workspace;
    std::optional<ViewContext> m_strokeView; ///< the view of pen-down holds for the whole sketch
    std::vector<glm::dvec2> m_path; ///< logical pixels
    QPointF m_cursor;
    std::optional<gpu::ViewId> m_cursorView;
};

} // namespace ui

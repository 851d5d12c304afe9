// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "ui/tools/common/CursorTool.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/Workspace.h"

#include <optional>
#include <vector>

namespace ui {

/// Adds chunks to the divided segment or removes them, with mouse or pen, in slices and in the 3D
/// view. A click removes a chunk that the segment contains and adds any other. A drag does to all
/// chunks on its way what it did to the first. With Ctrl, or the pen's eraser end, chunks are only
/// removed. Each stroke is one edit, made when the pen is lifted.
class ChunkTool : public CursorTool {
    Q_OBJECT

public:
    explicit ChunkTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    void changeRadius(int steps) override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    using Chunk = Chunks::Chunk;
    struct Stroke {
        ViewContext view; ///< the view at pen-down, used for the whole stroke
        QPointF last;
        core::ChunkToggle edit; ///< a point for each chunk
        std::vector<Chunk> chunks; ///< in the order of its points
        bool removes = false; ///< it only removes
    };

    /// Adds the chunks between the last point and this one.
    void follow(const QPointF& to);
    void pick(const glm::ivec3& voxel);
    void point(const QPointF& pixel, const ViewContext& view, bool removes);
    void forget();
    [[nodiscard]] QString segmentName() const;
    [[nodiscard]] QString chunkText(Chunk chunk) const;
    [[nodiscard]] QString whyNot() const;

    Workspace& m_workspace;
    std::optional<Stroke> m_stroke;
    std::optional<Chunk> m_pointed; ///< chunk under the pointer
    bool m_removes = false;
};

} // namespace ui

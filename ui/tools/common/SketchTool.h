// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"
#include "ui/tools/aim/SeenVoxels.h"

#include <QColor>
#include <QStringList>

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Sketches voxels: on a slice those under the path, on the 3D view those that are seen under it
/// (seed A §5.1). What becomes of them at pen-up the tools say.
class SketchTool : public Tool {
    Q_OBJECT

public:
    explicit SketchTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString keys() const override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

protected:
    /// Whether the pen's eraser end means something to it.
    [[nodiscard]] virtual bool takesEraser() const { return false; }
    /// A stroke that is no sketch: carried out here, and no voxels are committed.
    /// @param pixels of pen-down's view, at least one
    virtual bool finishOtherwise(const std::vector<glm::dvec2>&, const ViewContext&)
    {
        return false;
    }
    // While the pen is down, for tools that show what they will do.
    virtual void sketchBegan(const ViewContext&) { }
    virtual void sketchGrew(const std::vector<glm::dvec2>& /*pixels*/) { }
    virtual void sketchOver() { } ///< dropped, or committed if it met anything
    /// Words at the cursor, the most important ones first.
    [[nodiscard]] virtual QStringList cursorLines() const { return {target()}; }
    /// Each voxel once, in the order of the sketch; at least one.
    virtual void commit(const std::vector<glm::ivec3>& voxels) = 0;
    /// What the sketch is drawn in.
    [[nodiscard]] virtual QColor colour() const = 0;
    /// Said where a sketch met no voxel.
    [[nodiscard]] virtual QString outsideText() const = 0;
    [[nodiscard]] virtual QString nothingSeenText() const = 0;

    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    /// Of the sketch that is drawn or committed: as at pen-down.
    [[nodiscard]] Qt::KeyboardModifiers modifiers() const { return m_modifiers; }
    [[nodiscard]] bool withEraser() const { return m_withEraser; }
    [[nodiscard]] bool drawing() const { return m_strokeView.has_value(); }

private:
    [[nodiscard]] bool commitOnSlice(); ///< whether it is one
    void askWhatIsSeen();
    void commitSeen(const core::Result<SeenVoxels>& seen);

    Workspace& m_workspace;
    std::optional<ViewContext> m_strokeView; ///< the view of pen-down holds for the whole sketch
    std::vector<glm::dvec2> m_path; ///< logical pixels
    Qt::KeyboardModifiers m_modifiers;
    bool m_withEraser = false;
    QPointF m_cursor;
    std::optional<gpu::ViewId> m_cursorView;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/aim/SeenVoxels.h"
#include "ui/tools/aim/SketchedVoxels.h"
#include "ui/tools/common/CursorTool.h"

#include <QColor>
#include <QJsonObject>
#include <QStringList>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QToolButton;

namespace ui {

class Workspace;

/// Base of the tools that sketch voxels: on a slice those under the path, on the 3D view those that
/// are seen under it (seed A §5.1). On request the path of a pen is as wide as the pen is pressed;
/// a mouse always draws a line. Each tool decides what to do with them at pen-up.
class SketchTool : public CursorTool {
    Q_OBJECT

public:
    explicit SketchTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    /// Undo drops the last sketch whose voxels on the 3D view are not known yet.
    [[nodiscard]] bool canTakeStepBack() const override { return !m_waiting.empty(); }
    void takeStepBack() override;
    [[nodiscard]] QString stepText() const override;
    /// Changes how far to each side a pen reaches that is fully pressed.
    void changeRadius(int steps) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

Q_SIGNALS:
    void settingsChanged();

protected:
    /// Creates the switch for the width, for the tool's options.
    [[nodiscard]] QToolButton* widthButton(QWidget* parent);
    /// How wide a pen sketches that is fully pressed, in words; empty if pressure has no effect.
    [[nodiscard]] QStringList widthLines() const;
    /// Half of the width of the present sketch at its widest point, pixels; 0: it is a line.
    [[nodiscard]] double widestPixels() const;
    /// Handles a stroke that is not a sketch of voxels. If it returns true, commit() is not called.
    /// @param pixels path in the view at pen-down, at least one point
    virtual bool finishOtherwise(const std::vector<glm::dvec2>&, const ViewContext&)
    {
        return false;
    }
    // Called while the pen is down, for tools that show what they will do.
    virtual void sketchBegan(const ViewContext&) { }
    virtual void sketchGrew(const SketchPath&) { }
    virtual void sketchOver() { } ///< the sketch was dropped, or committed if it met any voxel
    /// The text at the cursor, the most important line first.
    [[nodiscard]] virtual QStringList cursorLines() const
    {
        return QStringList{target()} + widthLines();
    }
    /// Carries out the sketch.
    /// @param voxels at least one; each once, in the order of the sketch
    virtual void commit(const std::vector<glm::ivec3>& voxels) = 0;
    /// The colour of the sketch.
    [[nodiscard]] virtual QColor colour() const = 0;
    /// Messages for a sketch that met no voxel.
    [[nodiscard]] virtual QString outsideText() const = 0;
    [[nodiscard]] virtual QString nothingSeenText() const = 0;

    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    /// The modifiers at pen-down of the sketch that is drawn or committed.
    [[nodiscard]] Qt::KeyboardModifiers modifiers() const { return m_drawn.modifiers; }
    /// Whether it is drawn with Ctrl or with the pen's eraser end.
    [[nodiscard]] bool isInverse() const
    {
        return m_drawn.withEraser || m_drawn.modifiers.testFlag(Qt::ControlModifier);
    }
    /// The segment that was active at pen-up of the sketch that is committed, in the 3D view maybe
    /// long ago; 0: none was.
    [[nodiscard]] int segment() const { return m_drawn.segment; }
    [[nodiscard]] std::uint8_t growthPlane() const { return m_drawn.growthPlane; } ///< likewise
    /// Voxels on which the user saw a surface, each with the direction of view
    /// (LookingDirection.h), while a sketch is committed; empty: it was drawn on a slice or on
    /// brightest voxels.
    using SeenAlong = std::vector<std::pair<glm::ivec3, glm::dvec3>>;
    [[nodiscard]] const SeenAlong& seenAlong() const { return m_seenAlong; }
    [[nodiscard]] bool drawing() const { return m_strokeView.has_value(); }
    /// Asks for the present sketch, which waits for the answer (SeenVoxels.h).
    /// @param then not called if the sketch is dropped meanwhile
    void askWhatIsSeen(const gpu::VolumeScene& scene, const std::vector<glm::dvec2>& planeMm,
        const std::function<void(const core::Result<SeenVoxels>&)>& then);

private:
    /// What belongs to a sketch until it is committed, which may be after the next one began.
    struct Drawn {
        Qt::KeyboardModifiers modifiers{}; ///< at pen-down
        bool withEraser = false;
        int segment = 0; ///< at pen-up, as is the plane
        std::uint8_t growthPlane = 0;
    };

    [[nodiscard]] bool commitOnSlice(); ///< returns whether the view is a slice
    void addPoint(const PointerSample& sample);
    void paintSketch(QPainter& painter) const;
    void askForSketch();
    void commitSeen(const core::Result<SeenVoxels>& seen, const gpu::VolumeScene& scene);

    Workspace& m_workspace;
    std::optional<ViewContext> m_strokeView; ///< the view at pen-down, used for the whole sketch
    SketchPath m_path;
    bool m_byPressure = false;
    double m_reachMm = 3.0; ///< to each side, of a pen that is fully pressed
    double m_pressedPixels = 0.0; ///< the same at pen-down, in pixels; 0: the sketch is a line
    Drawn m_drawn;
    std::vector<std::shared_ptr<const Drawn>> m_waiting; ///< for answers, the last one at the end
    SeenAlong m_seenAlong;
};

} // namespace ui

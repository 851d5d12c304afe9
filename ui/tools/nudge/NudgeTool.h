// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/sculpt/labels/NudgeStart.h"
#include "ui/input/Tool.h"
#include "ui/tools/nudge/NudgeAim.h"

#include <QPointF>

#include <memory>
#include <optional>

namespace core {
struct PaintStroke;
struct Segment;
} // namespace core

namespace ui {

class Workspace;

/// Pushes the border of the active segment in a slice with a disc: outwards if it is pressed inside
/// of the segment, inwards beside it; with Ctrl or the pen's eraser end the other way round. The
/// voxel under the centre decides when the pen goes down, and the cursor says it before. The disc
/// has one radius however firmly a pen is pressed; by default it is made so small that it begins
/// wholly on one side of the border (core/sculpt/labels/NudgeStart.h). Each stroke is one step,
/// shown while the pen is down. Which voxels may change is set as for painting.
///
/// Where a stroke begins is found out beside the window; until then it keeps where the pen goes.
class NudgeTool : public Tool {
    Q_OBJECT

public:
    struct Settings {
        double radiusMm = 8.0;
        bool fits = true; ///< the radius is at most the distance to the border at pen-down
        bool operator==(const Settings&) const = default;
    };

    explicit NudgeTool(Workspace& workspace, QObject* parent = nullptr);
    ~NudgeTool() override;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override { return view.isSlice(); }

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    void changeRadius(int steps) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    [[nodiscard]] const Settings& settings() const { return m_settings; }
    void setSettings(const Settings& settings);
    /// Whether a stroke was begun that the session has not been told to the end.
    [[nodiscard]] bool isPushing() const { return m_stroke != nullptr; }
    /// Of the disc under the pointer, as far as that is known yet; none beside the slices, and
    /// before the first answer.
    [[nodiscard]] const std::optional<core::NudgeStart>& start() const { return m_start; }
    /// Of the stroke, or of one that would begin under the pointer.
    [[nodiscard]] double radiusMm() const;

Q_SIGNALS:
    void settingsChanged();

private:
    struct Stroke;

    /// The active segment, or else the first; null: there is none.
    [[nodiscard]] const core::Segment* nudged() const;
    /// A stroke that begins here, as an edit rounds it; which way it pushes is still open.
    [[nodiscard]] core::PaintStroke strokeAt(
        const QPointF& pixel, const ViewContext& view, int segment) const;
    void begin(const core::Result<core::NudgeStart>& start);
    void finish();
    /// Finds out where a stroke would begin that is pressed under the pointer.
    void lookAhead();
    /// Which way it pushes; none: that is not known yet.
    [[nodiscard]] std::optional<bool> pushesOutwards() const;
    void showCursor(const PointerSample& sample, const ViewContext& view);

    Workspace& m_workspace;
    Settings m_settings;
    std::unique_ptr<Stroke> m_stroke; ///< null: none
    std::optional<core::NudgeStart> m_start;
    std::optional<ViewContext> m_view; ///< under the pointer
    QPointF m_cursor;
    bool m_isInverse = false;
    bool m_looksAgain = false; ///< the pointer went on while that was found out
    NudgeAim m_aim; ///< last: its answers use all of the above
};

} // namespace ui

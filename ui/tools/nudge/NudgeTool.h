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
/// the segment, inwards if outside; with Ctrl or the pen's eraser end the other way round. The
/// voxel under the centre at pen-down decides, and the cursor shows it before. By default the disc
/// is made so small that it begins wholly on one side of the border
/// (core/sculpt/labels/NudgeStart.h). On request its radius follows the pressure of a pen, up to
/// that one. Each stroke is one step, which is shown while the pen is down. Which voxels may change
/// is set as for painting.
///
/// The start of a stroke is computed in the background (NudgeAim); until that is known the tool
/// stores the path of the pen.
class NudgeTool : public Tool {
    Q_OBJECT

public:
    struct Settings {
        double radiusMm = 8.0;
        bool fits = true; ///< the radius is at most the distance to the border at pen-down
        bool radiusByPressure = false; ///< of a pen; else its pressure does nothing
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
    /// Takes back a stroke under the pen. A stroke whose pen was lifted stays, even if it is not
    /// known yet how it begins.
    void cancel() override;
    /// Undo drops a stroke whose pen was lifted while it is not known yet how it begins.
    [[nodiscard]] bool canTakeStepBack() const override;
    void takeStepBack() override { drop(); }
    [[nodiscard]] QString stepText() const override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    void changeRadius(int steps) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    [[nodiscard]] const Settings& settings() const { return m_settings; }
    void setSettings(const Settings& settings);
    /// Whether there is a stroke that was not passed to the session completely yet.
    [[nodiscard]] bool isPushing() const { return m_stroke != nullptr; }
    /// How a stroke under the pointer would begin, as far as known; none outside slices and before
    /// the first answer.
    [[nodiscard]] const std::optional<core::NudgeStart>& start() const { return m_start; }
    /// The radius of the present stroke, or of one that would begin under the pointer; at full
    /// pressure.
    [[nodiscard]] double radiusMm() const;

Q_SIGNALS:
    void settingsChanged();

private:
    struct Stroke;
    struct Place;

    /// The active segment, or the first one if none is active; null: there is no segment.
    [[nodiscard]] const core::Segment* nudged() const;
    /// A stroke that begins at a pixel, quantised as an edit is. Its direction of push is not set
    /// yet.
    [[nodiscard]] core::PaintStroke strokeAt(
        const QPointF& pixel, const ViewContext& view, int segment) const;
    void begin(const core::Result<core::NudgeStart>& start);
    void finish();
    void drop();
    /// Computes how a stroke under the pointer would begin.
    void lookAhead();
    /// Whether it pushes outwards; none: that is not known yet.
    [[nodiscard]] std::optional<bool> pushesOutwards() const;
    void showCursor(const PointerSample& sample, const ViewContext& view);

    Workspace& m_workspace;
    Settings m_settings;
    std::unique_ptr<Stroke> m_stroke; ///< null: none
    std::optional<core::NudgeStart> m_start;
    std::optional<ViewContext> m_view; ///< the view under the pointer
    QPointF m_cursor;
    bool m_isInverse = false;
    double m_share = 1.0; ///< the share of the radius at the cursor
    /// The pointer has moved since the question, so it is asked again after the answer.
    bool m_looksAgain = false;
    NudgeAim m_aim; ///< last: its answers use all of the above
};

} // namespace ui

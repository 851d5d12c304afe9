// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tasks/SketchLook.h"
#include "ui/tools/common/CursorTool.h"
#include "ui/tools/contour/ContourDrawing.h"
#include "ui/tools/contour/ContourGhost.h"
#include "ui/tools/contour/ContourRun.h"

#include <optional>

namespace ui {

class Workspace;

/// A contour that evolves live, from a bubble that is clicked on a slice or from the active segment
/// as it stands. It is watched (ContourRun), played forwards and backwards and changed by its
/// settings, until it is accepted, as one step at the generation that is shown, or aborted, which
/// leaves nothing. The interval is that of growth, which a bubble may set like a sketch does; which
/// voxels may change is set as for painting. ContourPanel has its controls.
class ContourTool : public CursorTool {
    Q_OBJECT

public:
    struct Settings {
        bool fromSegment = false; ///< from the active segment; else from a bubble
        double bubbleMm = 4.0;
        bool valuesOfBubble = true; ///< the interval is what is offered around the click
        int softness = 25; ///< of half the interval's width, per cent
        int smoothness = 50; ///< 0 … 100, as the next
        int edge = 0;
        double edgeGradient = 0.0; ///< modality units per mm; 0: none was chosen yet
        int generations = 100; ///< at most
        bool operator==(const Settings&) const = default;
    };
    static constexpr double minimumBubbleMm = 0.5;
    static constexpr double maximumBubbleMm = 100.0;
    static constexpr double maximumGradient = 1e6;

    explicit ContourTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    /// In the 3D view a contour is only seen.
    [[nodiscard]] bool worksIn(const ViewContext& view) const override
    {
        return view.isSlice() || m_run.track();
    }
    [[nodiscard]] bool takes(const PointerSample&, const ViewContext& view) const override
    {
        return view.isSlice();
    }

    void press(const PointerSample& sample, const ViewContext& view) override;
    /// Drops what is watched; else abandons one that was accepted and takes long.
    void cancel() override;
    /// What is watched is dropped, and the user hears of it. What was accepted goes on.
    void putAway() override;
    /// Undo drops what is watched.
    [[nodiscard]] bool canTakeStepBack() const override { return m_run.isOpen(); }
    void takeStepBack() override { drop(); }
    [[nodiscard]] QString stepText() const override { return tr("the contour that is watched"); }
    /// Enter accepts; the arrow keys go to the generation before and after.
    bool pressKey(int key) override;
    /// The bubble's.
    void changeRadius(int steps) override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    /// Begins as the settings say; a bubble at this place.
    void start(const glm::dvec3& placeLps);
    /// Makes a step of what is shown, after one that makes a segment for it where there is none.
    void accept();
    /// Leaves nothing of what is watched.
    void drop();
    [[nodiscard]] const ContourRun& run() const { return m_run; }
    [[nodiscard]] ContourRun& run() { return m_run; }

    [[nodiscard]] const Settings& settings() const { return m_settings; }
    /// What is watched follows them.
    void setSettings(const Settings& settings);
    /// The gradient that is chosen, or one that suits the volume.
    [[nodiscard]] double edgeGradient() const;
    /// Of the one that is shown: "generation 12 · +3.2 mL, −0.1 mL"; empty without one.
    [[nodiscard]] QString shownText() const;

Q_SIGNALS:
    void settingsChanged();

private:
    [[nodiscard]] core::EvolveContour edit() const;
    [[nodiscard]] QString intervalText() const;
    void follow();
    void takeValues(const core::SketchedCodes& sketched);
    void showRun();

    Workspace& m_workspace;
    Settings m_settings;
    ContourRun m_run;
    SketchLook m_look;
    bool m_awaitsValues = false; ///< it begins when they are known
    mutable ContourDrawing m_drawing; ///< in slices
    mutable ContourGhost m_ghost; ///< in the 3D view
    int m_segment = 0; ///< label, of what is watched; 0: it has none before it is accepted
    std::optional<glm::dvec3> m_bubbleLps; ///< of the same
    bool m_wasOpen = false;
};

} // namespace ui

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

/// Evolves a contour live, from a ball ("bubble") at a clicked place of a slice or from the active
/// segment. The user watches it (ContourRun), plays it forwards and backwards and changes its
/// settings. Accepting it makes one step that ends at the shown generation; aborting it leaves
/// nothing. With Ctrl, or the pen's eraser end, it erases: a part of the segment evolves, from the
/// bubble or from all around the segment, which accepting takes away (core::EvolveContour::erase).
/// The interval is that of growth, which a bubble may set as a sketch does; which voxels may change
/// is set as for painting. ContourPanel has the controls.
class ContourTool : public CursorTool {
    Q_OBJECT

public:
    struct Settings {
        bool fromSegment = false; ///< start from the active segment; false: from a bubble
        double bubbleMm = 4.0; ///< radius of the bubble
        /// A bubble sets the interval to the one suggested for its centre.
        bool valuesOfBubble = true;
        int softness = 25; ///< per cent of half the interval's width, 0 … 100
        int smoothness = 50; ///< 0 … 100; so is edge
        int edge = 0;
        double edgeGradient = 0.0; ///< modality units per mm; 0: not chosen, see edgeGradient()
        int generations = 100; ///< greatest number
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
    /// Slices, and the 3D view while there is a contour, which can only be looked at there.
    [[nodiscard]] bool worksIn(const ViewContext& view) const override
    {
        return view.isSlice() || m_run.track();
    }
    [[nodiscard]] bool takes(const PointerSample&, const ViewContext& view) const override
    {
        return view.isSlice();
    }

    void press(const PointerSample& sample, const ViewContext& view) override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    /// Ends an open contour. Without one, aborts an accepted contour that is still being computed.
    void cancel() override;
    /// Ends an open contour and tells the user. An accepted contour goes on.
    void putAway() override;
    /// Undo ends an open contour.
    [[nodiscard]] bool canTakeStepBack() const override { return m_run.isOpen(); }
    void takeStepBack() override { drop(); }
    [[nodiscard]] QString stepText() const override { return tr("the contour that is watched"); }
    /// While a contour is open: Enter accepts it, the left and right arrow keys go to the previous
    /// and next generation.
    bool pressKey(int key) override;
    /// Changes the radius of the bubble.
    void changeRadius(int steps) override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

    /// Starts a contour by the settings.
    /// @param placeLps centre of a bubble, LPS mm
    /// @param erases whether what evolves is taken away from the segment
    void start(const glm::dvec3& placeLps, bool erases = false);
    /// Makes the shown generation a step. If there is no segment, one is added before, as a step of
    /// its own.
    void accept();
    /// Ends an open contour; nothing of it is left.
    void drop();
    [[nodiscard]] const ContourRun& run() const { return m_run; }
    [[nodiscard]] ContourRun& run() { return m_run; }

    [[nodiscard]] const Settings& settings() const { return m_settings; }
    /// Changes the settings; an open contour follows them.
    void setSettings(const Settings& settings);
    /// The chosen gradient of an edge, or else one that suits the volume; modality units per mm.
    [[nodiscard]] double edgeGradient() const;
    /// A text about the shown generation: "generation 12 · +3.2 mL, −0.1 mL", or "generation 12 ·
    /// erases 3.2 mL". Empty without a contour.
    [[nodiscard]] QString shownText() const;

Q_SIGNALS:
    void settingsChanged();

private:
    [[nodiscard]] core::EvolveContour edit() const;
    [[nodiscard]] QString intervalText() const;
    [[nodiscard]] QColor ringColour() const;
    void follow();
    void takeValues(const core::SketchedCodes& sketched);
    void showRun();

    Workspace& m_workspace;
    Settings m_settings;
    ContourRun m_run;
    SketchLook m_look;
    bool m_awaitsValues = false; ///< the contour starts when the values around the bubble are known
    mutable ContourDrawing m_drawing; ///< in slices
    mutable ContourGhost m_ghost; ///< in the 3D view
    /// Label of the open contour's segment; 0: a segment that is added when it is accepted.
    int m_segment = 0;
    /// Centre of its bubble; none: it starts from the segment.
    std::optional<glm::dvec3> m_bubbleLps;
    bool m_erases = false; ///< likewise
    bool m_isInverse = false; ///< a click under the pointer would erase
    bool m_wasOpen = false;
};

} // namespace ui

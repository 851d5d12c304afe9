// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tasks/growth/SketchLook.h"
#include "ui/tools/common/CursorTool.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/contour/ContourDrawing.h"
#include "ui/tools/contour/ContourGhost.h"
#include "ui/tools/contour/ContourRun.h"
#include "ui/tools/contour/ContourSettings.h"

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Evolves a contour live, from a ball ("bubble") at a clicked place of a slice, from the active
/// segment, or from its pending seeds, each with a bubble around it. A click with Shift, or any
/// click where several bubbles are chosen, adds a bubble to the contour that is open. The user
/// watches it (ContourRun), plays it forwards and backwards and changes its settings. Accepting it
/// makes one step that ends at the shown generation; aborting it leaves nothing. With Ctrl, or the
/// pen's eraser end, it erases: a part of the segment evolves, from the bubble or from all around
/// the segment, which accepting takes away (core::EvolveContour::erase). On request the greatest
/// pressure of the pen before it is lifted sets the radius of a bubble. The interval is that of
/// growth, which a bubble may set as a sketch does; which voxels may change is set as for painting.
/// ContourPanel has the controls.
class ContourTool : public CursorTool {
    Q_OBJECT

public:
    using Start = ContourSettings::Start;

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
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    /// Ends an open contour. Without one, aborts an accepted contour that is still being computed.
    void cancel() override;
    /// Ends an open contour and tells the user. An accepted contour goes on.
    void putAway() override;
    /// Undo takes back bubbles that were added to an open contour, and then ends it.
    [[nodiscard]] bool canTakeStepBack() const override { return m_run.isOpen(); }
    void takeStepBack() override;
    [[nodiscard]] QString stepText() const override;
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
    /// Adds a bubble to the open contour, which is computed anew and goes on from the generation
    /// that is shown. Does the same as start() if there is none, or if it erases from all around
    /// the segment.
    void addBubble(const glm::dvec3& placeLps, bool erases = false);
    /// Makes the shown generation a step. If there is no segment, one is added before, as a step of
    /// its own.
    void accept();
    /// Ends an open contour; nothing of it is left.
    void drop();
    [[nodiscard]] const ContourRun& run() const { return m_run; }
    [[nodiscard]] ContourRun& run() { return m_run; }

    [[nodiscard]] const ContourSettings& settings() const { return m_settings; }
    /// Changes the settings; an open contour follows them.
    void setSettings(const ContourSettings& settings);
    /// The chosen gradient of an edge, or else one that suits the volume; modality units per mm.
    [[nodiscard]] double edgeGradient() const;
    /// A text about the shown generation: "generation 12 · +3.2 mL, −0.1 mL", or "generation 12 ·
    /// erases 3.2 mL". Empty without a contour.
    [[nodiscard]] QString shownText() const;

Q_SIGNALS:
    void settingsChanged();

private:
    [[nodiscard]] core::EvolveContour edit() const;
    [[nodiscard]] bool takesBubbles() const;
    [[nodiscard]] bool wantsFurtherBubble(const PointerSample& sample) const;
    [[nodiscard]] bool mayBeginAt(const glm::dvec3& placeLps) const;
    [[nodiscard]] std::vector<glm::dvec3> startingBubbles(const glm::dvec3& placeLps) const;
    void endClick();
    void dropClick();
    [[nodiscard]] double bubbleMm(const StrokePressure& pressed) const;
    void evolve();
    void begin();
    [[nodiscard]] QString intervalText() const;
    [[nodiscard]] QColor ringColour() const;
    /// The interval of growth before a bubble took its values.
    struct ValuesBefore {
        double lower = 0.0;
        double upper = 0.0;
    };

    /// A press that becomes a bubble, or begins with what there is.
    struct Click {
        glm::dvec3 placeLps{0.0};
        bool adds = false;
        bool erases = false;
    };

    void follow();
    void takeValues(const core::SketchedCodes& sketched);
    void showRun();

    Workspace& m_workspace;
    ContourSettings m_settings;
    ContourRun m_run;
    SketchLook m_look;
    bool m_awaitsValues = false; ///< the contour starts when the values around the bubble are known
    mutable ContourDrawing m_drawing; ///< in slices
    mutable ContourGhost m_ghost; ///< in the 3D view
    /// Label of the open contour's segment; 0: a segment that is added when it is accepted.
    int m_segment = 0;
    /// Centres of its bubbles; none: it starts from the segment.
    std::vector<glm::dvec3> m_bubblesLps;
    /// For each of them, at the end of the list, that was added while it was open: the interval
    /// before that.
    std::vector<ValuesBefore> m_added;
    std::optional<Click> m_click; ///< of a pen that is down, while its pressure is the radius
    StrokePressure m_pressure; ///< of that click
    StrokePressure m_ofBubbles; ///< of the first bubble of the open contour
    bool m_playsOn = false; ///< once the contour was computed from another bubble, too
    bool m_erases = false; ///< likewise
    bool m_isInverse = false; ///< a click under the pointer would erase
    bool m_adds = false; ///< it would add a bubble
    bool m_wasOpen = false;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/sculpt/ToolMask.h"
#include "core/measure/region/Measured.h"
#include "core/session/EditSession.h"
#include "gpu/frame/FrameSource.h"
#include "ui/geometry/ToolMaskOutline.h"
#include "ui/settings/EditableSettings.h"
#include "ui/settings/growth/GrowSettings.h"

#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace core {
enum class ShapeOperation : std::uint8_t;
}

namespace ui {

class Chunks;
class CuttingPlane;
class LayerLooks;
class PendingSeeds;
class Pieces;
class Refinement;
class Tool;
class ViewSteps;

/// What all views, tools and panels of one window share: the open session, and the state that is
/// not a step of undo (crosshair, window/level, active segment and layer, look of the 3D view, tool
/// settings).
///
/// Setters emit their signal only if the value has changed. GUI thread.
class Workspace : public QObject {
    Q_OBJECT

public:
    /// The direction in which a drill goes in.
    enum class Sweep { View, Normal, LeftRight, FrontBack, UpDown, Pen };
    /// The settings of drill and laser, which share the mask.
    struct DrillSettings {
        double radiusMm = 8.0; ///< half the width for shapes other than the circle
        double depthMm = 8.0; ///< in mode Rate: per second
        bool throughGaps = false;
        core::ToolMask::Kind shape = core::ToolMask::Kind::Circle;
        double heightRatio = 0.5; ///< height / width, for shapes where they differ
        double rotationDegrees = 0.0;
        double softnessMm = 0.0; ///< as in core::ToolMask
        bool turnsWithPen = true; ///< the mask rotates with the pen, in addition to rotationDegrees
        bool foreshortened = false; ///< the mask is foreshortened by the pen's tilt
        core::DrillMode mode = core::DrillMode::Limit;
        double floorMm = 30.0; ///< for mode Rate
        int pressureExponent = 2; ///< 1 … 3: the depth goes with this power of the pressure
        double laserDepthMm = 15.0; ///< depth of the laser
        Sweep sweep = Sweep::View; ///< for the drill
        bool freehand = false; ///< the outline replaces the shape
        ToolMaskOutline outline{}; ///< radiusMm is half of its longer side
        bool operator==(const DrillSettings&) const = default;
    };
    /// The settings of one brush; paint, carve brush and barrier have their own.
    struct BrushSettings {
        double radiusMm = 4.0;
        bool disc = false; ///< on slices: a disc in the slice instead of a ball
        bool square =
            false; ///< on slices: a square instead of the disc, a cube instead of the ball
        bool onlyBetween = false; ///< paint: only values from lower to upper
        double lower = 0.0; ///< modality units
        double upper = 0.0;
        bool overwriteUnlocked = false;
        bool radiusByPressure = false; ///< the radius follows the pressure of a pen
        bool followsEdges = false; ///< for paint, on slices
        double edgeTolerance = 0.0; ///< modality units; 0: none was chosen yet
        /// While it follows edges: a pen's pressure scales the tolerance, and the radius is
        /// constant.
        bool toleranceByPressure = false;
        static constexpr double greatestEdgeTolerance = 1e6;
        bool operator==(const BrushSettings&) const = default;
    };
    enum class Brush { Paint, Carve, Barrier };
    using GrowSettings = ui::GrowSettings;
    /// How the 3D view draws.
    struct VolumeDisplay {
        gpu::RenderMode mode = gpu::RenderMode::Surface;
        double surfaceThreshold = 300.0;
        gpu::TransferFunction transferFunction;
        /// The window of MIP, separate from that of slices: a window for soft tissue would saturate
        /// all bone along a ray.
        core::WindowLevel mipWindow;
        core::WindowLevel xrayWindow; ///< the window of X-ray, whose means are lowered by air
        gpu::CutFaces cutFaces = gpu::CutFaces::Material;
        gpu::Context context = gpu::Context::Opaque;
        double contextOpacity = 0.25; ///< of a translucent context
        bool operator==(const VolumeDisplay&) const = default;
    };

    /// The window for the grey values of a render mode; null if the mode shows no grey values.
    using GreyWindow = core::WindowLevel VolumeDisplay::*;
    [[nodiscard]] static GreyWindow greyWindow(gpu::RenderMode mode);

    /// Which parts of segments slices draw.
    enum class SegmentDrawing { FillAndOutline, Fill, Outline };
    /// What is drawn over the pictures, in every view.
    struct ViewOptions {
        bool showPatient = true; ///< name, ID and birth date in the corners
        bool showCrosshair = true;
        bool showSegments = true; ///< all segments at once; each keeps its own visibility
        bool showCarved = true; ///< in slices: what is carved away, as a tinted outline
        bool carvedAsHole = false; ///< in slices: what is carved away is black
        bool showBarriers = true; ///< barriers, in slices and in the 3D view
        bool inverted = false; ///< inverts the grey scale of slices
        gpu::ColourMap colours = gpu::ColourMap::Grey; ///< of slices, and of MIP in the 3D view
        /// Of slices and the cutting plane; none is the usual way: slices linear, the plane cubic.
        std::optional<gpu::Interpolation> interpolation{};
        gpu::SlabMode slabMode = gpu::SlabMode::Off; ///< of all slices
        double slabMm = 10.0; ///< thickness; each view rounds it to an odd number of its slices
        bool referenceLines = false; ///< in slices: where the other slices cut them
        bool linkedPlaces = false; ///< slices are zoomed and panned together
        SegmentDrawing segmentDrawing = SegmentDrawing::FillAndOutline; ///< of all segments
        int segmentFillPercent = 35; ///< opacity of their fill in slices
        /// The 3D view draws segments as cubes of voxels, without smoothing.
        bool voxelTrueSegments = false;
        /// The 3D view draws voxels that a change of the interval suspends; they stay marked after
        /// the drag.
        bool suspendedBodies = false;
        bool operator==(const ViewOptions&) const = default;
    };
    static constexpr int leastSegmentFill = 5; ///< percent
    /// How one slice view draws segments; members without a value are as in all views
    /// (ViewOptions).
    struct SegmentLook {
        std::optional<SegmentDrawing> drawing{};
        std::optional<int> fillPercent{};
        [[nodiscard]] bool isUsual() const { return !drawing && !fillPercent; }
        bool operator==(const SegmentLook&) const = default;
    };
    /// A SegmentLook with the values of ViewOptions filled in.
    struct DrawnSegments {
        SegmentDrawing drawing;
        int fillPercent;
    };

    explicit Workspace(gpu::FrameSource& frames, QObject* parent = nullptr);
    ~Workspace() override;

    [[nodiscard]] gpu::FrameSource& frames() { return m_frames; }
    /// Null while nothing is open.
    [[nodiscard]] core::EditSession* session() const { return m_session.get(); }
    [[nodiscard]] const core::Volume* volume() const; ///< the open volume, or null
    /// Opens another study (or none): moves the crosshair to its middle, and sets grey scale and 3D
    /// view to suit it.
    void setSession(std::unique_ptr<core::EditSession> session);
    /// Ends what is under way and closes the session, without emitting signals: the program ends,
    /// and windows may be gone.
    /// @return why the disk refuses the last steps, which are lost; none: they are on disk
    std::optional<core::Error> dropSession();

    /// Applies the user's setting of how much history the session keeps in memory
    /// (HistoryMemory.h).
    void applyHistoryMemory();

    [[nodiscard]] glm::dvec3 crosshairLps() const { return m_crosshairLps; }
    void setCrosshairLps(const glm::dvec3& position);
    [[nodiscard]] core::WindowLevel windowLevel() const { return m_windowLevel; }
    void setWindowLevel(const core::WindowLevel& window);
    [[nodiscard]] int activeSegment() const { return m_activeSegment; } ///< its label; 0: none
    /// The label plane of the active segment: its growth is the one that tools and panels begin,
    /// continue, take back and show. 0 if there is no segment.
    [[nodiscard]] std::uint8_t growthPlane() const;
    void setActiveSegment(int label);
    /// The layer that tools carve; 0: none.
    [[nodiscard]] int activeLayer() const { return m_activeLayer; }
    void setActiveLayer(int id);
    [[nodiscard]] const VolumeDisplay& volumeDisplay() const { return m_volumeDisplay; }
    void setVolumeDisplay(const VolumeDisplay& display);
    /// The part of the volume that the 3D view shows; not a step of the history. A new session
    /// shows all.
    [[nodiscard]] const core::ClipRegion& clip() const { return m_clip; }
    void setClip(const core::ClipRegion& clip);
    /// Changes of what is shown that the user can undo.
    [[nodiscard]] ViewSteps& viewSteps() const { return *m_viewSteps; }
    [[nodiscard]] Pieces& pieces() const { return *m_pieces; }
    [[nodiscard]] Refinement& refinement() const { return *m_refinement; }
    [[nodiscard]] CuttingPlane& plane() const { return *m_plane; }
    [[nodiscard]] Chunks& chunks() const { return *m_chunks; }
    /// The size and values of a measurement (measure/MeasuredRegions.h); null: not computed yet.
    /// Results are found by the whole measurement, so one that reuses the number of an undone
    /// measurement never gets that one's result.
    [[nodiscard]] const core::Measured* measured(const core::Measurement& measurement) const;
    void setMeasured(const core::Measured& measured);
    [[nodiscard]] PendingSeeds& seeds() const { return *m_seeds; }
    [[nodiscard]] LayerLooks& layerLooks() const { return *m_layerLooks; }
    [[nodiscard]] DrawnSegments drawnSegments(const SegmentLook& look) const;
    /// How segments are drawn, from the document and the view options.
    /// @param look of a view; without: as in all views
    [[nodiscard]] gpu::SegmentDisplay segmentDisplay(const SegmentLook& look) const;
    [[nodiscard]] gpu::SegmentDisplay segmentDisplay() const
    {
        return segmentDisplay(SegmentLook());
    }
    /// Draws what growth has added after a generation in the warning colour; none: nothing.
    void setWarnAfter(std::optional<std::uint32_t> generation);

    /// Draws a segment as it would be at a tolerance, if there is a tolerance field of it. A new
    /// session shows segments as they are.
    [[nodiscard]] const std::optional<gpu::ToleranceDisplay>& atTolerance() const
    {
        return m_atTolerance;
    }
    void setAtTolerance(const std::optional<gpu::ToleranceDisplay>& shown);
    [[nodiscard]] const DrillSettings& drillSettings() const { return m_drill; }
    void setDrillSettings(const DrillSettings& settings);
    [[nodiscard]] const BrushSettings& brushSettings(Brush brush) const;
    void setBrushSettings(Brush brush, const BrushSettings& settings);
    [[nodiscard]] const GrowSettings& growSettings() const { return m_grow; }
    void setGrowSettings(const GrowSettings& settings);

    /// The user's editable range, which limits the voxels that tools may change; off in a new
    /// session.
    [[nodiscard]] const EditableSettings& editableSettings() const { return m_editable; }
    void setEditableSettings(const EditableSettings& settings);
    /// The box to which editing may be limited: the clip box, or else the box of growth; none if
    /// neither is on.
    [[nodiscard]] std::optional<EditableBox> editableBox() const;
    /// The limits that an edit made now must contain; none while the range is off.
    [[nodiscard]] std::optional<core::EditableRange> editableRange() const;
    [[nodiscard]] QString editableText() const; ///< the range as a text; empty while it is off

    [[nodiscard]] const ViewOptions& viewOptions() const { return m_viewOptions; }
    void setViewOptions(const ViewOptions& options);

    static constexpr int leastSegmentOpacity = 5; ///< percent: none is lost from sight
    /// Opacity of segments in all views, per cent by label; a segment that is not listed is opaque.
    /// It is saved with the session and is no step of undo. A new session starts empty. A new
    /// segment that reuses the label of an undone one is opaque; an undone segment that returns
    /// keeps its opacity.
    [[nodiscard]] const std::map<int, int>& segmentOpacities() const { return m_opacities; }
    void setSegmentOpacities(const std::map<int, int>& percents);
    [[nodiscard]] int segmentOpacity(int label) const;
    void setSegmentOpacity(int label, int percent);
    /// Whether the user has accepted the problems of the open volume's geometry; until then every
    /// view carries a caution bar. A new session starts unaccepted.
    [[nodiscard]] bool cautionAccepted() const { return m_cautionAccepted; }
    void acceptCaution();
    /// The place under the pointer, for the status line; none while it is over no picture.
    [[nodiscard]] const std::optional<glm::dvec3>& pointedLps() const { return m_pointedLps; }
    void setPointedLps(const std::optional<glm::dvec3>& position);

    /// The active tool; null: the left button navigates.
    [[nodiscard]] Tool* activeTool() const { return m_tool; }
    void setActiveTool(Tool* tool);
    /// Takes the tool that was in hand before the active one, or, if none is active, the last one.
    /// @return whether there is one
    bool takeToolBefore();

    /// Asks every view to show a place in its middle.
    void centreViews(const glm::dvec3& placeLps) { Q_EMIT viewsCentred(placeLps); }
    /// Shows one sentence in the status line: what happened, to what, what to do.
    void say(const QString& sentence) { Q_EMIT said(sentence); }
    /// Announces that the session was moved to another file.
    /// @param before the previous file; empty if the session was read-only, or another program
    /// has taken the name from it
    void noteSaved(const QString& before, const QString& now) { Q_EMIT sessionSaved(before, now); }
    /// Reports a failure in the bar above the views.
    void fail(const core::Error& error) { Q_EMIT failed(error); }
    /// A sentence with a button, for the bar above the views.
    struct Offer {
        QString sentence;
        QString button;
        std::function<void()> run;
    };
    void offer(const Offer& made) { Q_EMIT offered(made); }
    /// Asks the window to open the dialog that reshapes a segment.
    void askToReshape(int label, core::ShapeOperation first) { Q_EMIT reshapeAsked(label, first); }
    /// Asks the window to open the dialog that fills a segment between slices.
    void askToFillBetween(int label) { Q_EMIT fillBetweenAsked(label); }
    /// Asks the window to open the dialog that mirrors a segment.
    void askToMirror(int label) { Q_EMIT mirrorAsked(label); }
    /// Asks the window to open the dialog that splits islands of a segment.
    void askToSplitIslands(int label) { Q_EMIT splitIslandsAsked(label); }
    /// Asks the window to open the dialog for a threshold of a segment.
    void askForThreshold(int label) { Q_EMIT thresholdAsked(label); }
    /// Shows the present pen pressure, 0 … 1.
    void showPressure(double pressure) { Q_EMIT pressureChanged(pressure); }

Q_SIGNALS:
    /// The open session is about to be closed; it can still be changed.
    void sessionClosing();
    void sessionChanged();
    void sessionSaved(const QString& before, const QString& now);
    void documentChanged(const core::DocumentChange& change);
    void crosshairChanged();
    void windowLevelChanged();
    void activeSegmentChanged();
    void activeLayerChanged();
    void volumeDisplayChanged();
    void clipChanged();
    void drillSettingsChanged();
    void brushSettingsChanged();
    void growSettingsChanged();
    /// The settings of the editable range, or the range that follows from them.
    void editableChanged();
    void atToleranceChanged();
    /// The view options, the warning of setWarnAfter(), or the opacity of a segment.
    void viewOptionsChanged();
    void cautionAcceptedChanged();
    void pointedLpsChanged();
    void measuredChanged();
    void activeToolChanged();
    void viewsCentred(const glm::dvec3& placeLps);
    void said(const QString& sentence);
    void failed(const core::Error& error);
    void offered(const ui::Workspace::Offer& made);
    void reshapeAsked(int label, core::ShapeOperation first);
    void fillBetweenAsked(int label);
    void mirrorAsked(int label);
    void splitIslandsAsked(int label);
    void thresholdAsked(int label);
    void pressureChanged(double pressure);

private:
    void followDisk();
    void followLayers();
    void followOpacities();

    /// The opacity of a segment that the document does not hold at present.
    struct LostOpacity {
        int percent = 100;
        /// The number of rows when its label was free for a new segment, which a row after these
        /// adds; none: no other segment can have it.
        std::optional<std::int64_t> rowsWhenFree{};
    };

    gpu::FrameSource& m_frames;
    std::unique_ptr<core::EditSession> m_session;
    glm::dvec3 m_crosshairLps{0.0};
    core::WindowLevel m_windowLevel;
    int m_activeSegment = 0;
    int m_activeLayer = 0;
    VolumeDisplay m_volumeDisplay;
    core::ClipRegion m_clip;
    ViewSteps* m_viewSteps = nullptr;
    Pieces* m_pieces = nullptr;
    PendingSeeds* m_seeds = nullptr;
    Refinement* m_refinement = nullptr;
    CuttingPlane* m_plane = nullptr;
    Chunks* m_chunks = nullptr;
    LayerLooks* m_layerLooks = nullptr;
    std::map<int, core::Measured> m_measured; ///< by number; they stand until the session closes
    DrillSettings m_drill;
    BrushSettings m_paint{.disc = true};
    BrushSettings m_carve;
    BrushSettings m_barrier;
    GrowSettings m_grow;
    EditableSettings m_editable;
    std::optional<gpu::ToleranceDisplay> m_atTolerance;
    ViewOptions m_viewOptions;
    std::map<int, int> m_opacities; ///< of segments, in percent by label; none is 100
    std::map<int, LostOpacity> m_lostOpacities; ///< by label
    bool m_cautionAccepted = false;
    std::optional<std::uint32_t> m_warnAfter;
    std::optional<glm::dvec3> m_pointedLps;
    Tool* m_tool = nullptr;
    std::array<QPointer<Tool>, 2> m_lastTools; ///< the last one that was active, and before it
    QTimer m_retry; ///< runs while steps wait for the disk
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/sculpt/MaskShape.h"
#include "core/session/EditSession.h"
#include "gpu/frame/FrameSource.h"
#include "ui/geometry/MaskOutline.h"
#include "ui/settings/GrowSettings.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

namespace ui {

class Chunks;
class ClipSteps;
class CuttingPlane;
class LayerLooks;
class PendingSeeds;
class Pieces;
class Refinement;
class Tool;

/// What all views, tools and panels of one window share: the open session and the state that is not
/// a step of undo (crosshair, window/level, active segment and layer, how the 3D view looks, tool
/// settings).
///
/// Setters emit their signal only when the value changed.
class Workspace : public QObject {
    Q_OBJECT

public:
    /// Which way a drill goes in.
    enum class Sweep { View, Normal, LeftRight, FrontBack, UpDown, Pen };
    /// Of drill and laser: they share the tip.
    struct DrillSettings {
        double radiusMm = 8.0; ///< of other shapes than the circle: half the width
        double depthMm = 8.0; ///< mode Rate: a second
        bool throughGaps = false;
        core::MaskShape::Kind shape = core::MaskShape::Kind::Circle;
        double heightRatio = 0.5; ///< height to width, where they differ
        double rotationDegrees = 0.0;
        double softnessMm = 0.0; ///< core::MaskShape's
        bool turnsWithPen = true; ///< the mask, on top of rotationDegrees
        bool foreshortened = false; ///< the mask, by the pen's tilt
        core::DrillMode mode = core::DrillMode::Limit;
        double floorMm = 30.0; ///< mode Rate
        int pressureExponent = 2; ///< 1 … 3: the depth goes with this power of the pressure
        double laserDepthMm = 15.0; ///< the laser's depthMm
        Sweep sweep = Sweep::View; ///< the drill's
        bool freehand = false; ///< the outline in place of the shape
        MaskOutline outline{}; ///< radiusMm is half its greater side
        bool operator==(const DrillSettings&) const = default;
    };
    /// Of paint, of the carve brush and of barriers, each its own.
    struct BrushSettings {
        double radiusMm = 4.0;
        bool disc = false; ///< on slices: of the shown slice only, not a ball
        bool onlyBetween = false; ///< paint: only values from lower to upper
        double lower = 0.0; ///< modality units
        double upper = 0.0;
        bool overwriteUnlocked = false;
        bool operator==(const BrushSettings&) const = default;
    };
    enum class Brush { Paint, Carve, Barrier };
    using GrowSettings = ui::GrowSettings;
    /// How the 3D view draws.
    struct VolumeDisplay {
        gpu::RenderMode mode = gpu::RenderMode::Surface;
        double surfaceThreshold = 300.0;
        gpu::TransferFunction transferFunction;
        /// Its own: what shows soft tissue on a slice drowns every bone along a ray.
        core::WindowLevel mipWindow;
        core::WindowLevel xrayWindow; ///< of means, which air thins
        gpu::CutFaces cutFaces = gpu::CutFaces::Material;
        bool operator==(const VolumeDisplay&) const = default;
    };

    /// The window that a display's grey values go through; null: its mode shows no grey values.
    using GreyWindow = core::WindowLevel VolumeDisplay::*;
    [[nodiscard]] static GreyWindow greyWindow(gpu::RenderMode mode);

    /// What lies over the pictures, in every view.
    struct ViewOptions {
        bool showPatient = true; ///< name, ID and birth date in the corners
        bool showCrosshair = true;
        bool showSegments = true; ///< all segments at once; each keeps its own visibility
        bool showCarved = true; ///< in slices: what is carved away, as a tinted outline
        bool carvedAsHole = false; ///< in slices: what is carved away is black
        bool showBarriers = true; ///< what is shut to growth, in slices and in the 3D view
        bool inverted = false; ///< of slices: grey scale the other way round
        bool operator==(const ViewOptions&) const = default;
    };

    explicit Workspace(gpu::FrameSource& frames, QObject* parent = nullptr);
    ~Workspace() override;

    [[nodiscard]] gpu::FrameSource& frames() { return m_frames; }
    /// Null while nothing is open.
    [[nodiscard]] core::EditSession* session() const { return m_session.get(); }
    [[nodiscard]] const core::Volume* volume() const; ///< the open volume, or null
    /// Shows another study (or none): crosshair to its middle, grey scale and 3D view to what suits
    /// it.
    void setSession(std::unique_ptr<core::EditSession> session);
    /// Closes the session without a word to anybody: the program ends, and windows may be gone.
    void dropSession();

    /// The open session keeps as much of its history in memory as the user allows
    /// (HistoryMemory.h).
    void applyHistoryMemory();

    [[nodiscard]] glm::dvec3 crosshairLps() const { return m_crosshairLps; }
    void setCrosshairLps(const glm::dvec3& position);
    [[nodiscard]] core::WindowLevel windowLevel() const { return m_windowLevel; }
    void setWindowLevel(const core::WindowLevel& window);
    [[nodiscard]] int activeSegment() const { return m_activeSegment; } ///< label; 0: none
    void setActiveSegment(int label);
    [[nodiscard]] int activeLayer() const { return m_activeLayer; } ///< that tools carve; 0: none
    void setActiveLayer(int id);
    [[nodiscard]] const VolumeDisplay& volumeDisplay() const { return m_volumeDisplay; }
    void setVolumeDisplay(const VolumeDisplay& display);
    /// What of the volume the 3D view shows; no step of the history. A new session shows all.
    [[nodiscard]] const core::ClipRegion& clip() const { return m_clip; }
    void setClip(const core::ClipRegion& clip);
    /// The way for whatever the user does to the clip, so that undo takes it back.
    [[nodiscard]] ClipSteps& clipSteps() const { return *m_clipSteps; }
    [[nodiscard]] Pieces& pieces() const { return *m_pieces; }
    [[nodiscard]] Refinement& refinement() const { return *m_refinement; }
    [[nodiscard]] CuttingPlane& plane() const { return *m_plane; }
    [[nodiscard]] Chunks& chunks() const { return *m_chunks; }
    [[nodiscard]] PendingSeeds& seeds() const { return *m_seeds; }
    [[nodiscard]] LayerLooks& layerLooks() const { return *m_layerLooks; }
    [[nodiscard]] gpu::SegmentDisplay segmentDisplay() const; ///< from the document
    /// What growth added after a generation is drawn in the warning colour; none: nothing is.
    void setWarnAfter(std::optional<std::uint32_t> generation);

    /// A segment is drawn as it would be at a tolerance, where there is a field of it; a new
    /// session shows what is.
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

    [[nodiscard]] const ViewOptions& viewOptions() const { return m_viewOptions; }
    void setViewOptions(const ViewOptions& options);
    /// Whether the user has accepted what is wrong with the open volume's geometry; until then
    /// every view carries a caution bar. A new session starts unaccepted.
    [[nodiscard]] bool cautionAccepted() const { return m_cautionAccepted; }
    void acceptCaution();
    /// Where the pointer is; none while it is over no picture. For the status line.
    [[nodiscard]] const std::optional<glm::dvec3>& pointedLps() const { return m_pointedLps; }
    void setPointedLps(const std::optional<glm::dvec3>& position);

    /// Null: navigate.
    [[nodiscard]] Tool* activeTool() const { return m_tool; }
    void setActiveTool(Tool* tool);

    /// One sentence for the status line: what happened, to what, what to do.
    void say(const QString& sentence) { Q_EMIT said(sentence); }
    /// The session goes on in another file. @param before the one it left; empty: it was looked at
    /// only
    void tellSaved(const QString& before, const QString& now) { Q_EMIT sessionSaved(before, now); }
    /// What could not be done, for the bar above the views.
    void fail(const core::Error& error) { Q_EMIT failed(error); }
    /// Something that can be done about what happened; for the bar above the views.
    struct Offer {
        QString sentence;
        QString button;
        std::function<void()> run;
    };
    void offer(const Offer& made) { Q_EMIT offered(made); }
    /// Pen pressure as it comes, 0 … 1.
    void showPressure(double pressure) { Q_EMIT pressureChanged(pressure); }

Q_SIGNALS:
    /// The open session is about to be closed; it can still be told things.
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
    void atToleranceChanged();
    void viewOptionsChanged(); ///< or what warns
    void cautionAcceptedChanged();
    void pointedLpsChanged();
    void activeToolChanged();
    void said(const QString& sentence);
    void failed(const core::Error& error);
    void offered(const ui::Workspace::Offer& made);
    void pressureChanged(double pressure);

private:
    void followDisk();
    void followLayers();

    gpu::FrameSource& m_frames;
    std::unique_ptr<core::EditSession> m_session;
    glm::dvec3 m_crosshairLps{0.0};
    core::WindowLevel m_windowLevel;
    int m_activeSegment = 0;
    int m_activeLayer = 0;
    VolumeDisplay m_volumeDisplay;
    core::ClipRegion m_clip;
    ClipSteps* m_clipSteps = nullptr;
    Pieces* m_pieces = nullptr;
    PendingSeeds* m_seeds = nullptr;
    Refinement* m_refinement = nullptr;
    CuttingPlane* m_plane = nullptr;
    Chunks* m_chunks = nullptr;
    LayerLooks* m_layerLooks = nullptr;
    DrillSettings m_drill;
    BrushSettings m_paint{.disc = true};
    BrushSettings m_carve;
    BrushSettings m_barrier;
    GrowSettings m_grow;
    std::optional<gpu::ToleranceDisplay> m_atTolerance;
    ViewOptions m_viewOptions;
    bool m_cautionAccepted = false;
    std::optional<std::uint32_t> m_warnAfter;
    std::optional<glm::dvec3> m_pointedLps;
    Tool* m_tool = nullptr;
    QTimer m_retry; ///< runs while steps wait for the disk
};

} // namespace ui

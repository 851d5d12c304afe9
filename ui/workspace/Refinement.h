// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/refine/mesh/SurfaceMark.h"
#include "core/refine/mesh/SurfaceMirror.h"
#include "gpu/scene/Scene.h"

#include <QObject>

#include <optional>
#include <vector>

namespace core {
struct ChangeMarks;
}

namespace ui {

class Workspace;

/// The surface that is being refined, as the window uses it: how it looks, what is marked on it,
/// and operations on all of it. Tools edit it through the session. Part of Workspace.
class Refinement : public QObject {
    Q_OBJECT

public:
    /// How it is drawn; not a step of undo.
    struct Look {
        gpu::SurfaceStyle style = gpu::SurfaceStyle::Shaded;
        float opacity = 1.0f;
        bool showMarks = true;
        bool contours = true; ///< draws lines where it meets slices
        bool operator==(const Look&) const = default;
    };
    enum class Mode { Mark, Sphere, Scrape, Drag, Smooth, Attract, Template };
    /// The settings of the refine tool.
    struct Settings {
        Mode mode = Mode::Mark;
        core::SurfaceMark mark = core::SurfaceMark::Red;
        double radiusMm = 8.0;
        bool radiusByPressure = false; ///< of a pen; else its pressure does nothing
        bool operator==(const Settings&) const = default;
    };

    explicit Refinement(Workspace& workspace);

    /// The state of the surface; none if no surface is being refined.
    [[nodiscard]] std::optional<core::RefinedSurface> surface() const;
    /// A copy of the surface as last reported by the session, where views show it; it follows while
    /// an edit is under way.
    [[nodiscard]] const core::SurfaceMirror& mirror() const { return m_mirror; }
    /// The same, with the same ids, where it truly lies; views show unevenly spaced slices as if
    /// they were evenly spaced.
    [[nodiscard]] const core::SurfaceMirror& trueMirror() const
    {
        return m_trueMirror.empty() ? m_mirror : m_trueMirror;
    }
    /// The parts that are marked red and not signed off, largest first, where views show them.
    [[nodiscard]] const std::vector<core::MarkedRegion>& errors() const { return m_errors; }

    [[nodiscard]] const Look& look() const { return m_look; }
    void setLook(const Look& look);
    [[nodiscard]] const Settings& settings() const { return m_settings; }
    void setSettings(const Settings& settings);

    /// What the 3D view and slices draw of it; none if nothing.
    [[nodiscard]] std::optional<gpu::SceneSurface> scene() const;
    [[nodiscard]] std::optional<gpu::SceneContour> contour() const;
    /// The label whose body the 3D view leaves out because its surface is drawn; 0: none. Edges
    /// alone hide nothing: behind them the body stays, to compare.
    [[nodiscard]] int bodiless() const;
    /// The label that the cutting plane shows reddish, so that the line of its surface stands out
    /// from it; 0: none, or nothing of the surface is drawn.
    [[nodiscard]] int mask() const;

    /// Contours of a template that were drawn but not applied (seed B §4.4), LPS as views show
    /// them.
    [[nodiscard]] const std::vector<std::vector<glm::dvec3>>& contours() const
    {
        return m_contours;
    }
    /// Adds a contour. If its ends meet it is closed and describes a body. A preview is taken back.
    void addContour(std::vector<glm::dvec3> pointsLps);
    void removeContour(); ///< removes the last one
    void removeContourAt(std::size_t place); ///< its index in contours()
    void clearContours();
    /// Previews the surface that the contours produce. takeTemplate() makes an edit of it,
    /// dropPreview() takes it back and keeps the contours.
    void previewTemplate();
    [[nodiscard]] bool isPreviewing() const;
    /// Whether there is a preview, and the session has not refused it.
    [[nodiscard]] bool canTakeTemplate() const;
    /// Makes the preview an edit. The contours are removed; they come back if the edit is refused
    /// after all.
    void takeTemplate();
    void dropPreview();

    /// The caution in views while the segment differs from what the surface encloses; else empty.
    [[nodiscard]] QString caution() const;

    /// Makes the surface of the active segment.
    /// @param vertices how many the surface is to have
    void lay(int vertices);
    /// Aborts the computation that is under way: a surface that is being made or follows the mask,
    /// or a template that still moves. isAbortable() says whether there is one. Contours stay, and
    /// come back if they were taken.
    void abort();
    [[nodiscard]] bool isAbortable() const;
    void writeBack();
    void followMask();
    /// Fits those parts of the surface anew that pass through each other; all else stays.
    void layCrossings();
    /// Makes the surface a barrier for growth; with @p erase, opens it again.
    void makeBarrier(bool erase);
    void drop();
    /// Changes all marks of the tool's colour (red where it is yellow) in this way.
    void changeMarks(core::ChangeMarks change);
    /// Goes to the next error, or the previous one (@p by −1): moves the crosshair there.
    void goToError(int by);
    /// @param place in errors()
    void showError(int place);
    /// Moves the crosshair and the views to a part of the surface.
    /// @param region in the places where views show it (ShownSurface.h)
    void showRegion(const core::MarkedRegion& region);
    /// Signs an error off: it turns green.
    /// @param place index in errors()
    void signOff(int place);

Q_SIGNALS:
    void changed(); ///< the surface, or its marks
    void lookChanged();
    void settingsChanged();
    void contoursChanged(); ///< the contours, or whether they are previewed
    /// An error is to be shown.
    /// @param normalLps outwards; 0: from any direction
    void shown(const glm::dvec3& placeLps, const glm::dvec3& normalLps);

private:
    void follow();
    void followTaken();
    void returnRefused();
    [[nodiscard]] bool areTakenBack() const;
    [[nodiscard]] bool isTakenThrough() const;
    void forgetTaken();
    void take(const core::SurfaceUpdate& shown, const std::optional<core::SurfaceUpdate>& truth);
    void apply(const core::Edit& edit);
    [[nodiscard]] gpu::SurfaceColours colours() const;

    Workspace& m_workspace;
    core::SurfaceMirror m_mirror;
    core::SurfaceMirror m_trueMirror; ///< empty where slices are evenly spaced
    std::vector<core::MarkedRegion> m_errors;
    int m_error = -1; ///< index of the error last visited
    Look m_look;
    Settings m_settings;
    std::vector<std::vector<glm::dvec3>> m_contours;
    /// Contours that were taken and whose template still moves; they come back if it is aborted.
    std::vector<std::vector<glm::dvec3>> m_taken;
    std::size_t m_rowsAtTaking = 0;
};

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/refine/mesh/SurfaceMirror.h"
#include "gpu/scene/Scene.h"

#include <QObject>

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// The surface that is being refined, as the window has it: what it looks like, what is marked on
/// it, what is done to all of it. Tools work on it through the session. Part of Workspace.
class Refinement : public QObject {
    Q_OBJECT

public:
    /// How it is drawn; no step of undo.
    struct Look {
        gpu::SurfaceStyle style = gpu::SurfaceStyle::Shaded;
        float opacity = 1.0f;
        bool showMarks = true;
        bool contours = true; ///< where it meets slices
        bool operator==(const Look&) const = default;
    };
    enum class Mode { Mark, Sphere, Scrape, Drag, Smooth, Attract, Template };
    /// Of the tool.
    struct Settings {
        Mode mode = Mode::Mark;
        core::SurfaceMark mark = core::SurfaceMark::Red;
        double radiusMm = 8.0;
        bool operator==(const Settings&) const = default;
    };

    explicit Refinement(Workspace& workspace);

    /// None: no surface is being refined.
    [[nodiscard]] std::optional<core::RefinedSurface> surface() const;
    /// As far as it was told of: while something is under way it follows.
    [[nodiscard]] const core::SurfaceMirror& mirror() const { return m_mirror; }
    /// What is marked red and not signed off, largest first.
    [[nodiscard]] const std::vector<core::MarkedRegion>& errors() const { return m_errors; }

    [[nodiscard]] const Look& look() const { return m_look; }
    void setLook(const Look& look);
    [[nodiscard]] const Settings& settings() const { return m_settings; }
    void setSettings(const Settings& settings);

    /// What the 3D view and slices draw of it; none: nothing.
    [[nodiscard]] std::optional<gpu::SceneSurface> scene() const;
    [[nodiscard]] std::optional<gpu::SceneContour> contour() const;

    /// Contours of a template that have been drawn but not taken (seed B §4.4), LPS.
    [[nodiscard]] const std::vector<std::vector<glm::dvec3>>& contours() const
    {
        return m_contours;
    }
    /// One more. One whose ends meet is closed: it describes a body. What is previewed is taken
    /// back.
    void addContour(std::vector<glm::dvec3> pointsLps);
    void removeContour(); ///< the last one
    void clearContours();
    /// The surface shows what the contours make of it; takeTemplate() makes an edit of that,
    /// dropPreview() takes it back and keeps the contours.
    void previewTemplate();
    [[nodiscard]] bool isPreviewing() const;
    void takeTemplate();
    void dropPreview();

    /// What views say while the segment does not hold what the surface encloses; empty: it does.
    [[nodiscard]] QString caution() const;

    /// Around the active segment.
    void lay(int vertices);
    void writeBack();
    void followMask();
    /// Growth does not pass through the surface from now on; with @p erase it does again.
    void makeBarrier(bool erase);
    void drop();
    void changeMarks(core::ChangeMarks::Way way);
    /// To the next error, or the one before (@p by −1): the crosshair goes there.
    void goToError(int by);
    /// @param place in errors()
    void showError(int place);
    /// A part of the surface is looked at: the crosshair and the views go there.
    void showRegion(const core::MarkedRegion& region);
    /// It turns green. @param place in errors()
    void signOff(int place);

Q_SIGNALS:
    void changed(); ///< it, or what is marked on it
    void lookChanged();
    void settingsChanged();
    void contoursChanged(); ///< or whether what they make of the surface is looked at
    /// An error is to be looked at. @param normalLps outwards; 0: from wherever
    void shown(const glm::dvec3& placeLps, const glm::dvec3& normalLps);

private:
    void follow();
    void take(const core::SurfaceUpdate& update);
    void apply(const core::Edit& edit);
    [[nodiscard]] gpu::SurfaceColours colours() const;

    Workspace& m_workspace;
    core::SurfaceMirror m_mirror;
    std::vector<core::MarkedRegion> m_errors;
    int m_error = -1; ///< the one that was gone to
    Look m_look;
    Settings m_settings;
    std::vector<std::vector<glm::dvec3>> m_contours;
};

} // namespace ui

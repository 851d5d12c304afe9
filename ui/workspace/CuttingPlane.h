// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"
#include "gpu/scene/Scene.h"
#include "ui/geometry/ViewPlane.h"

#include <QObject>

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// The cutting plane (seed B §4.1): one for all views. The pen view shows it as a slice, the 3D
/// view as a rectangle in the volume, slices as a line. It is not a step of undo. Part of
/// Workspace.
///
/// It is viewed against its normal, like slices: "above" is the side of the viewer.
class CuttingPlane : public QObject {
    Q_OBJECT

public:
    struct Pose {
        glm::dvec3 centreLps{0.0};
        glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit
        glm::dvec3 downLps{0.0, 1.0, 0.0}; ///< unit, perpendicular to rightLps
        [[nodiscard]] glm::dvec3 normalLps() const; ///< right × down: away from the viewer
        bool operator==(const Pose&) const = default;
    };
    struct Look {
        bool shown = false; ///< in the 3D view, and as a line in slices
        float opacity = 1.0f; ///< in the 3D view
        bool clipsAbove = false; ///< hides matter and surface above it in the 3D view
        bool operator==(const Look&) const = default;
    };

    explicit CuttingPlane(Workspace& workspace);

    [[nodiscard]] const Pose& pose() const { return m_pose; }
    void setPose(const Pose& pose);
    [[nodiscard]] const Look& look() const { return m_look; }
    void setLook(const Look& look);
    void show(); ///< shows it if it is hidden

    /// A pose with this normal that is upright if possible: the feet, or else the back, are towards
    /// the bottom of the picture.
    [[nodiscard]] static Pose poseFacing(const glm::dvec3& centreLps, const glm::dvec3& normalLps);
    void align(SliceOrientation orientation); ///< makes it a standard plane through the crosshair
    /// Moves it along its normal; away from the viewer is positive.
    void move(double mm);
    /// Turns it about an axis through its centre, by the right-hand rule.
    /// @param axisLps unit
    void turn(const glm::dvec3& axisLps, double degrees);
    void flip(); ///< turns it over, to be seen from its other side
    /// Makes it pass through three points; does nothing if they lie on a line.
    /// @return whether it could
    bool passThrough(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
    /// Makes it perpendicular to a direction, such as that of a vessel.
    void cutAcross(const glm::dvec3& placeLps, const glm::dvec3& directionLps);
    /// Makes it stand on a surface: turns it as little as possible so that it contains the
    /// surface's normal.
    void standOn(const glm::dvec3& placeLps, const glm::dvec3& surfaceNormalLps);

    /// Does one of both, whichever fits the values around a place: cuts across a tube, or stands on
    /// a surface. The engine is asked, so it happens later.
    void askAcross(const glm::dvec3& placeLps);

    /// The polygon in which it cuts the volume, as corners in order (LPS); empty if it misses it.
    [[nodiscard]] std::vector<glm::dvec3> section() const;
    /// The plane for the 3D view, as large as its section; none if it is hidden or misses the
    /// volume.
    [[nodiscard]] std::optional<gpu::ScenePlane> scene() const;
    /// The half space that it hides in the 3D view; none if nothing.
    [[nodiscard]] std::optional<core::ClipPlane> clip() const;

Q_SIGNALS:
    void changed(); ///< where it lies, or how it looks

private:
    void openVolume();

    Workspace& m_workspace;
    Pose m_pose;
    Look m_look;
};

/// What the 3D view shows of the volume: the clip region, whose first free plane is what the
/// cutting plane hides. Where the user has three planes of his own, only the surface is cut by it.
[[nodiscard]] core::ClipRegion shownClip(const Workspace& workspace);

} // namespace ui

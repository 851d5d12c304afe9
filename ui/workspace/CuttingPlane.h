// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"
#include "gpu/scene/Scene.h"
#include "ui/geometry/SlicePlane.h"

#include <QObject>

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// The cutting plane (seed B §4.1): one for all views, wherever it was put. The pen view shows it
/// as a slice, the 3D view among the matter, slices as a line. No step of undo. Part of Workspace.
///
/// It is looked at against its normal, as slices are: "above" is the viewer's side.
class CuttingPlane : public QObject {
    Q_OBJECT

public:
    struct Pose {
        glm::dvec3 centreLps{0.0};
        glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit
        glm::dvec3 downLps{0.0, 1.0, 0.0}; ///< unit, at right angles to it
        [[nodiscard]] glm::dvec3 normalLps() const; ///< right × down: away from the viewer
        bool operator==(const Pose&) const = default;
    };
    struct Look {
        bool shown = false; ///< in the 3D view, and as a line in slices
        float opacity = 1.0f; ///< in the 3D view
        bool clipsAbove = false; ///< matter and surface that lie above it are not seen in 3D
        bool operator==(const Look&) const = default;
    };

    explicit CuttingPlane(Workspace& workspace);

    [[nodiscard]] const Pose& pose() const { return m_pose; }
    void setPose(const Pose& pose);
    [[nodiscard]] const Look& look() const { return m_look; }
    void setLook(const Look& look);
    void show(); ///< if it is hidden

    /// Upright where that can be told: the feet, else the back, lie towards the picture's bottom.
    [[nodiscard]] static Pose poseFacing(const glm::dvec3& centreLps, const glm::dvec3& normalLps);
    void align(SliceOrientation orientation); ///< through the crosshair
    /// Along its normal; away from the viewer is positive.
    void move(double mm);
    /// About an axis through its centre, by the right hand. @param axisLps unit
    void turn(const glm::dvec3& axisLps, double degrees);
    void flip(); ///< seen from its other side
    /// Through three places; nothing where they lie on a line. @return whether they do not
    bool passThrough(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);
    /// Across what runs along a direction, such as a vessel.
    void cutAcross(const glm::dvec3& placeLps, const glm::dvec3& directionLps);
    /// Upright on a surface: turned as little as may be so that it holds its normal.
    void standOn(const glm::dvec3& placeLps, const glm::dvec3& surfaceNormalLps);

    /// One of both, by how values run around a place: the engine is asked, and answers by and by.
    void askAcross(const glm::dvec3& placeLps);

    /// What of the volume it cuts, as corners in order around it (LPS); empty: nothing.
    [[nodiscard]] std::vector<glm::dvec3> section() const;
    /// As the 3D view shows it: as large as its section. None: hidden, or beyond the volume.
    [[nodiscard]] std::optional<gpu::ScenePlane> scene() const;
    /// What it hides in the 3D view; none: nothing.
    [[nodiscard]] std::optional<core::ClipPlane> clip() const;

Q_SIGNALS:
    void changed(); ///< where it lies, or how it looks

private:
    void openVolume();

    Workspace& m_workspace;
    Pose m_pose;
    Look m_look;
};

} // namespace ui

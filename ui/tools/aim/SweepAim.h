// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/HiddenSides.h"
#include "ui/workspace/Workspace.h"

#include <QPointF>

namespace ui {

/// A stroke of the drill that does not go in along the view: the edit gets a view of its own, which
/// looks the way the drill goes and at the place under the pen. So any recipe can say the same.
class SweepAim {
public:
    /// @param drawnIn the view that the pen moves in
    /// @param placeLps of the surface under the pen when it went down
    /// @param direction unit, not against the view
    SweepAim(const core::OrthographicView& drawnIn, const glm::dvec3& placeLps,
        const glm::dvec3& direction);

    [[nodiscard]] const core::OrthographicView& view() const { return m_view; }
    /// What lies more than this before the place is passed through: it is not what the pen is on.
    [[nodiscard]] core::HiddenSide before(double mm) const;
    /// A place of the plane that the mask begins in, from its middle.
    [[nodiscard]] glm::dvec3 toLps(const glm::dvec2& ownMm) const
    {
        return m_view.targetLps + m_axes * glm::dvec3(ownMm, 0.0);
    }
    /// Where the pen is, in the view of its own.
    [[nodiscard]] glm::dvec2 toOwn(const glm::dvec2& drawnMm) const;

private:
    core::OrthographicView m_drawnIn;
    glm::dmat3 m_drawnAxes{1.0}; ///< right, up, forward
    core::OrthographicView m_view;
    glm::dmat3 m_axes{1.0};
};

/// Which way a drill goes in; unit. @param normal of the surface under the pen, into the material
/// @param tiltDegrees of the pen: from upright, positive to the right and towards the user
[[nodiscard]] glm::dvec3 sweepDirection(Workspace::Sweep sweep, const core::OrthographicView& view,
    const glm::dvec3& normal, const QPointF& tiltDegrees);

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "ui/workspace/Workspace.h"

#include <QPointF>

namespace ui {

/// The aim of a drill stroke that does not go in along the view direction. The edit then gets a
/// view of its own, which looks along the drill at the point under the pen; so a recipe can express
/// the same.
class SweepAim {
public:
    /// @param drawnIn the view that the pen moves in
    /// @param placeLps surface point under the pen when it went down
    /// @param direction unit, not against the view
    SweepAim(const core::OrthographicView& drawnIn, const glm::dvec3& placeLps,
        const glm::dvec3& direction);

    [[nodiscard]] const core::OrthographicView& view() const { return m_view; }
    /// The half space that lies more than this far in front of the place: it is passed through,
    /// because it is not what the pen points at.
    [[nodiscard]] core::ClipHalfSpace before(double mm) const;
    /// A point of the mask plane, given by its position relative to the plane's middle, in LPS.
    [[nodiscard]] glm::dvec3 toLps(const glm::dvec2& ownMm) const
    {
        return m_view.targetLps + m_axes * glm::dvec3(ownMm, 0.0);
    }
    /// The position of the pen in the edit's own view.
    [[nodiscard]] glm::dvec2 toOwn(const glm::dvec2& drawnMm) const;

private:
    core::OrthographicView m_drawnIn;
    glm::dmat3 m_drawnAxes{1.0}; ///< right, up, forward
    core::OrthographicView m_view;
    glm::dmat3 m_axes{1.0};
};

/// The tangent of a pen's tilt; a pen that lies flatter than 70° counts as one of 70°.
[[nodiscard]] double tiltTangent(double degrees);

/// The direction in which a drill goes in; unit.
/// @param normal of the surface under the pen, into the material
[[nodiscard]] glm::dvec3 sweepDirection(Workspace::Sweep sweep, const core::OrthographicView& view,
    const glm::dvec3& normal, const QPointF& tiltDegrees);

} // namespace ui

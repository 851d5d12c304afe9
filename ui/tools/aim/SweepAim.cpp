// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/SweepAim.h"

#include "core/edits/kinds/parts/ClipHalfSpaces.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double eyeMm = 300.0;
/// No sweep is closer to lying in the view plane: the pen's way on it would run off.
const double leastAlong = std::cos(75.0 * 3.14159265358979323846 / 180.0);
constexpr double steepestTiltDegrees = 70.0;

glm::dmat3 axesOf(const core::OrthographicView& view)
{
    const glm::dvec3 forward = glm::normalize(view.targetLps - view.eyeLps);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, view.up));
    return glm::dmat3(right, glm::cross(right, forward), forward);
}

} // namespace

double tiltTangent(double degrees)
{
    return std::tan(std::clamp(degrees, -steepestTiltDegrees, steepestTiltDegrees)
        * (3.14159265358979323846 / 180.0));
}

SweepAim::SweepAim(
    const core::OrthographicView& drawnIn, const glm::dvec3& placeLps, const glm::dvec3& direction)
    : m_drawnIn(drawnIn)
    , m_drawnAxes(axesOf(drawnIn))
    , m_view(drawnIn)
{
    m_view.targetLps = placeLps;
    m_view.eyeLps = placeLps - eyeMm * direction;
    if (glm::length(glm::cross(direction, m_view.up)) < 0.05 * glm::length(m_view.up))
        m_view.up = m_drawnAxes[0];
    m_axes = axesOf(m_view);
}

core::ClipHalfSpace SweepAim::before(double mm) const
{
    const glm::dvec3 towardsEye = -m_axes[2];
    return {towardsEye, glm::dot(towardsEye, m_view.targetLps) + mm};
}

glm::dvec2 SweepAim::toOwn(const glm::dvec2& drawnMm) const
{
    // Beside the place first, then along the line of sight to the plane that the mask moves in.
    const glm::dvec3& sight = m_drawnAxes[2];
    glm::dvec3 met = m_drawnIn.targetLps + m_drawnAxes * glm::dvec3(drawnMm, 0.0);
    met += sight * glm::dot(m_view.targetLps - met, sight);
    const double along = std::max(glm::dot(sight, m_axes[2]), leastAlong);
    met += sight * (glm::dot(m_view.targetLps - met, m_axes[2]) / along);
    const glm::dvec3 own = glm::transpose(m_axes) * (met - m_view.targetLps);
    return {own.x, own.y};
}

glm::dvec3 sweepDirection(Workspace::Sweep sweep, const core::OrthographicView& view,
    const glm::dvec3& normal, const QPointF& tiltDegrees)
{
    const glm::dmat3 axes = axesOf(view);
    const auto along = [&axes](glm::dvec3 axis) {
        return glm::dot(axis, axes[2]) < 0.0 ? -axis : axis;
    };
    switch (sweep) {
    case Workspace::Sweep::View:
        break;
    case Workspace::Sweep::Normal:
        return normal;
    case Workspace::Sweep::LeftRight:
        return along({1.0, 0.0, 0.0});
    case Workspace::Sweep::FrontBack:
        return along({0.0, 1.0, 0.0});
    case Workspace::Sweep::UpDown:
        return along({0.0, 0.0, 1.0});
    case Workspace::Sweep::Pen:
        // Its upper end leans to the right and to the user, its tip points the other way.
        return glm::normalize(
            axes * glm::dvec3(-tiltTangent(tiltDegrees.x()), tiltTangent(tiltDegrees.y()), 1.0));
    }
    return axes[2];
}

} // namespace ui

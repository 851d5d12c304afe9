// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/CuttingPlane.h"

#include "core/session/questions/VoxelQuestions.h"
#include "core/volume/LocalStructure.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ui {

namespace {

constexpr double acrossMm = 7.0; // so far around a place it is asked what runs there
constexpr double leastTurn = 1e-6; // a sine below which two directions are one

CuttingPlane::Pose poseOf(const SliceAxes& axes, const glm::dvec3& centreLps)
{
    return {.centreLps = centreLps, .rightLps = axes.rightLps, .downLps = axes.downLps};
}

} // namespace

glm::dvec3 CuttingPlane::Pose::normalLps() const
{
    return glm::cross(rightLps, downLps);
}

CuttingPlane::CuttingPlane(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, &CuttingPlane::openVolume);
}

void CuttingPlane::openVolume()
{
    m_look = {};
    if (const core::Volume* volume = m_workspace.volume())
        m_pose = poseOf(sliceAxes(SliceOrientation::Axial),
            volume->geometry.toWorld(0.5 * glm::dvec3(volume->geometry.size - 1)));
    Q_EMIT changed();
}

void CuttingPlane::setPose(const Pose& pose)
{
    if (pose == m_pose)
        return;
    m_pose = pose;
    Q_EMIT changed();
}

void CuttingPlane::setLook(const Look& look)
{
    if (look == m_look)
        return;
    m_look = look;
    Q_EMIT changed();
}

void CuttingPlane::show()
{
    Look look = m_look;
    look.shown = true;
    setLook(look);
}

CuttingPlane::Pose CuttingPlane::poseFacing(
    const glm::dvec3& centreLps, const glm::dvec3& normalLps)
{
    const glm::dvec3 normal = glm::normalize(normalLps);
    const glm::dvec3 feet(0.0, 0.0, -1.0);
    const glm::dvec3 back(0.0, 1.0, 0.0);
    // Nearly axial planes are shown as axial slices are.
    const glm::dvec3 towards = std::abs(normal.z) < 0.9 ? feet : back;
    const glm::dvec3 down = glm::normalize(towards - glm::dot(towards, normal) * normal);
    return {.centreLps = centreLps, .rightLps = glm::cross(down, normal), .downLps = down};
}

void CuttingPlane::align(SliceOrientation orientation)
{
    setPose(poseOf(sliceAxes(orientation), m_workspace.crosshairLps()));
}

void CuttingPlane::move(double mm)
{
    Pose pose = m_pose;
    pose.centreLps += mm * pose.normalLps();
    setPose(pose);
}

void CuttingPlane::turn(const glm::dvec3& axisLps, double degrees)
{
    const glm::dmat3 rotation(glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axisLps));
    Pose pose = m_pose;
    pose.rightLps = glm::normalize(rotation * pose.rightLps);
    // At right angles after any number of turns.
    const glm::dvec3 down = rotation * pose.downLps;
    pose.downLps = glm::normalize(down - glm::dot(down, pose.rightLps) * pose.rightLps);
    setPose(pose);
}

void CuttingPlane::flip()
{
    Pose pose = m_pose;
    pose.rightLps = -pose.rightLps;
    setPose(pose);
}

bool CuttingPlane::passThrough(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double sides = glm::length(b - a) * glm::length(c - a);
    if (glm::length(across) <= leastTurn * sides)
        return false;
    // Seen from the side it was seen from.
    const glm::dvec3 normal = glm::normalize(across);
    const double sense = glm::dot(normal, m_pose.normalLps()) < 0.0 ? -1.0 : 1.0;
    setPose(poseFacing((a + b + c) / 3.0, sense * normal));
    return true;
}

void CuttingPlane::cutAcross(const glm::dvec3& placeLps, const glm::dvec3& directionLps)
{
    const double sense = glm::dot(directionLps, m_pose.normalLps()) < 0.0 ? -1.0 : 1.0;
    setPose(poseFacing(placeLps, sense * directionLps));
}

void CuttingPlane::standOn(const glm::dvec3& placeLps, const glm::dvec3& surfaceNormalLps)
{
    const glm::dvec3 up = glm::normalize(surfaceNormalLps);
    const auto beside = [&up](const glm::dvec3& direction) {
        return direction - glm::dot(direction, up) * up;
    };
    glm::dvec3 normal = beside(m_pose.normalLps());
    if (glm::length(normal) < leastTurn)
        normal = beside(m_pose.downLps);
    setPose(poseFacing(placeLps, normal));
}

void CuttingPlane::askAcross(const glm::dvec3& placeLps)
{
    core::EditSession* session = m_workspace.session();
    const core::Volume* volume = m_workspace.volume();
    if (!session || !volume)
        return;
    const glm::dvec3 spacing = volume->geometry.spacingMm();
    // Where voxels are long a few millimetres would hold none of their neighbours.
    const double radiusMm = std::max(acrossMm, 2.5 * std::max({spacing.x, spacing.y, spacing.z}));
    const core::VoxelBox box = core::localStructureBox(volume->geometry, placeLps, radiusMm);
    if (box.empty())
        return m_workspace.say(tr("That lies beyond the volume"));
    session->questions().codes(
        box, [=, self = QPointer(this)](const core::Result<std::vector<std::uint16_t>>& codes) {
            if (!self || !self->m_workspace.volume())
                return;
            if (!codes)
                return self->m_workspace.fail(codes.error());
            const auto structure = core::localStructure(
                *codes, box, self->m_workspace.volume()->geometry, placeLps, radiusMm);
            if (!structure)
                return self->m_workspace.say(tr("Nothing runs there: values do not change"));
            if (structure->isTube())
                self->cutAcross(placeLps, structure->directions[2]);
            else
                self->standOn(placeLps, structure->directions[0]);
            self->m_workspace.say(structure->isTube()
                    ? tr("The plane lies across what runs there")
                    : tr("The plane stands on the surface there"));
        });
}

std::vector<glm::dvec3> CuttingPlane::section() const
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return {};
    return core::boxSection(core::wholeVolume(volume->geometry).box, volume->geometry,
        m_pose.centreLps, m_pose.normalLps());
}

std::optional<gpu::ScenePlane> CuttingPlane::scene() const
{
    const std::vector<glm::dvec3> corners = section();
    if (!m_look.shown || corners.empty())
        return std::nullopt;
    glm::dvec2 low(std::numeric_limits<double>::max());
    glm::dvec2 high(std::numeric_limits<double>::lowest());
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 way = corner - m_pose.centreLps;
        const glm::dvec2 place(glm::dot(way, m_pose.rightLps), glm::dot(way, m_pose.downLps));
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const glm::dvec2 middle = 0.5 * (low + high);
    return gpu::ScenePlane{
        .centreLps = m_pose.centreLps + middle.x * m_pose.rightLps + middle.y * m_pose.downLps,
        .rightLps = m_pose.rightLps,
        .downLps = m_pose.downLps,
        .halfSizeMm = 0.5 * (high - low),
        .window = m_workspace.windowLevel(),
        .inverted = m_workspace.viewOptions().inverted,
        .colours = m_workspace.viewOptions().colours,
        .interpolation =
            m_workspace.viewOptions().interpolation.value_or(gpu::Interpolation::Cubic),
        .opacity = m_look.opacity,
        .contour = m_workspace.refinement().contour(),
        .mask = m_workspace.refinement().mask(),
        .showCarved = m_workspace.viewOptions().showCarved};
}

std::optional<core::ClipPlane> CuttingPlane::clip() const
{
    if (!m_look.shown || !m_look.clipsAbove)
        return std::nullopt;
    return core::ClipPlane{
        .pointLps = m_pose.centreLps, .normalLps = -m_pose.normalLps(), .on = true};
}

core::ClipRegion shownClip(const Workspace& workspace)
{
    core::ClipRegion region = workspace.clip();
    const std::optional<core::ClipPlane> above = workspace.plane().clip();
    const auto unused = std::find_if(region.planes.begin(), region.planes.end(),
        [](const core::ClipPlane& plane) { return !plane.on; });
    if (above && unused != region.planes.end())
        *unused = *above;
    return region;
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "ui/views/MprPlanes.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// The cosine of the least angle between two planes, about 10°.
constexpr double nearestCosine = 0.985;

/// By the right-hand rule, and made exact again, so that many small turns add no error.
SliceAxes turnedAbout(const glm::dvec3& axis, double radians, const SliceAxes& axes)
{
    const auto turned = [&](const glm::dvec3& v) {
        return std::cos(radians) * v + std::sin(radians) * glm::cross(axis, v)
            + (1.0 - std::cos(radians)) * glm::dot(axis, v) * axis;
    };
    const glm::dvec3 right = glm::normalize(turned(axes.rightLps));
    glm::dvec3 down = turned(axes.downLps);
    down = glm::normalize(down - glm::dot(down, right) * right);
    return {right, down, glm::cross(right, down)};
}

} // namespace

MprPlanes::MprPlanes(QObject* parent)
    : QObject(parent)
{
    for (const SliceOrientation each : all)
        m_axes[std::size_t(each)] = sliceAxes(each);
}

const SliceAxes& MprPlanes::axes(SliceOrientation plane) const
{
    return m_axes[std::size_t(plane)];
}

bool MprPlanes::alongPatient() const
{
    return std::all_of(all.begin(), all.end(), [this](SliceOrientation each) {
        const SliceAxes upright = sliceAxes(each);
        return axes(each).rightLps == upright.rightLps && axes(each).downLps == upright.downLps;
    });
}

void MprPlanes::reset()
{
    if (alongPatient())
        return;
    for (const SliceOrientation each : all)
        m_axes[std::size_t(each)] = sliceAxes(each);
    Q_EMIT changed();
}

void MprPlanes::turnOthers(SliceOrientation seenIn, double radians)
{
    for (const SliceOrientation each : all) {
        if (each != seenIn)
            m_axes[std::size_t(each)] = turnedAbout(axes(seenIn).normalLps, radians, axes(each));
    }
    Q_EMIT changed();
}

void MprPlanes::turnOne(SliceOrientation seenIn, SliceOrientation plane, double radians)
{
    if (plane == seenIn)
        return;
    const SliceAxes turned = turnedAbout(axes(seenIn).normalLps, radians, axes(plane));
    for (const SliceOrientation each : all) {
        if (each != plane
            && std::abs(glm::dot(axes(each).normalLps, turned.normalLps)) > nearestCosine)
            return;
    }
    m_axes[std::size_t(plane)] = turned;
    Q_EMIT changed();
}

void MprPlanes::set(SliceOrientation plane, const glm::dvec3& rightLps, const glm::dvec3& downLps)
{
    m_axes[std::size_t(plane)] = {rightLps, downLps, glm::cross(rightLps, downLps)};
    Q_EMIT changed();
}

} // namespace ui

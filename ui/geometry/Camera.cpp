// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/Camera.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double eyeDistanceMm = 2000.0;
const glm::dvec3 head(0.0, 0.0, 1.0);

glm::dvec3 turned(const glm::dvec3& vector, const glm::dvec3& axis, double radians)
{
    const double c = std::cos(radians);
    return vector * c + glm::cross(axis, vector) * std::sin(radians)
        + axis * (glm::dot(axis, vector) * (1.0 - c));
}

} // namespace

glm::dvec3 Camera::eyeLps() const
{
    return targetLps + towardsViewer * std::max(eyeDistanceMm, 4.0 * heightMm);
}

void Camera::orbit(double rightwards, double downwards)
{
    // Seen from below, "upright" is upside down and so is the turntable's sense.
    const double sense = up.z < 0.0 ? -1.0 : 1.0;
    const double turn = -glm::radians(rightwards) * sense;
    towardsViewer = glm::normalize(turned(towardsViewer, head, turn));
    up = glm::normalize(turned(up, head, turn));
    const glm::dvec3 axis = right();
    const double tilt = -glm::radians(downwards);
    towardsViewer = glm::normalize(turned(towardsViewer, axis, tilt));
    up = glm::normalize(glm::cross(towardsViewer, axis));
}

void Camera::turn(const glm::dvec3& degrees)
{
    const double angle = glm::length(degrees);
    if (angle <= 0.0)
        return;
    // The camera goes the other way round.
    const glm::dvec3 axis = glm::dmat3(right(), up, towardsViewer) * (degrees / angle);
    towardsViewer = glm::normalize(turned(towardsViewer, axis, -glm::radians(angle)));
    up = turned(up, axis, -glm::radians(angle));
    // At right angles after any number of turns.
    up = glm::normalize(up - glm::dot(up, towardsViewer) * towardsViewer);
}

void Camera::zoom(double factor)
{
    heightMm = std::clamp(heightMm * factor, 1.0, 1e4);
}

void Camera::pan(double rightMm, double downMm)
{
    targetLps += up * downMm - right() * rightMm;
}

void Camera::lookFrom(const glm::dvec3& sideLps)
{
    towardsViewer = glm::normalize(sideLps);
    const bool alongBody = std::abs(towardsViewer.z) > 0.99;
    // From above and below the front of the body is up, as on an axial slice.
    const glm::dvec3 wanted = alongBody ? glm::dvec3(0.0, -1.0, 0.0) : head;
    const glm::dvec3 side = glm::normalize(glm::cross(wanted, towardsViewer));
    up = glm::cross(towardsViewer, side);
}

} // namespace ui

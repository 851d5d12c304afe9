// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace ui {

/// An orthographic camera that turns around a point of the patient.
struct Camera {
    glm::dvec3 targetLps{0.0};
    glm::dvec3 towardsViewer{0.0, -1.0, 0.0}; ///< unit; from the target to the eye
    glm::dvec3 up{0.0, 0.0, 1.0}; ///< unit, perpendicular to towardsViewer
    double heightMm = 300.0; ///< height of the scene that the picture shows

    [[nodiscard]] glm::dvec3 right() const { return glm::cross(up, towardsViewer); }
    /// A position of the eye that is outside of anything within heightMm of the target.
    [[nodiscard]] glm::dvec3 eyeLps() const;

    /// Turns like a turntable: the patient's long axis stays upright. Angles in degrees; the object
    /// follows the pointer to the right and downwards.
    void orbit(double rightwards, double downwards);
    /// Turns the object about an axis through the target, right, up or towards the viewer or in
    /// between, by the right-hand rule.
    /// @param degrees along the axis
    void turn(const glm::dvec3& degrees);
    /// Multiplies the height of the scene, within what can be seen.
    void zoom(double factor);
    /// Moves the target so that the object follows the pointer, in millimetres of the view plane (y
    /// down).
    void pan(double rightMm, double downMm);
    /// Looks from this side of the patient, e.g. (0, −1, 0) from the front.
    void lookFrom(const glm::dvec3& sideLps);
};

} // namespace ui

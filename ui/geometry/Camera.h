// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace ui {

/// An orthographic camera that walks around a point of the patient.
struct Camera {
    glm::dvec3 targetLps{0.0};
    glm::dvec3 towardsViewer{0.0, -1.0, 0.0}; ///< unit; from the target to the eye
    glm::dvec3 up{0.0, 0.0, 1.0}; ///< unit, at right angles to towardsViewer
    double heightMm = 300.0; ///< what the picture's height shows

    [[nodiscard]] glm::dvec3 right() const { return glm::cross(up, towardsViewer); }
    /// Far enough outside anything within heightMm of the target.
    [[nodiscard]] glm::dvec3 eyeLps() const;

    /// Turntable: the patient's long axis stays upright. Angles in degrees; the object follows the
    /// pointer to the right and downwards.
    void orbit(double rightwards, double downwards);
    /// The object follows the pointer, in view plane millimetres (y down).
    void pan(double rightMm, double downMm);
    /// Look from this side of the patient, e.g. (0, −1, 0) from the front.
    void lookFrom(const glm::dvec3& sideLps);
};

} // namespace ui

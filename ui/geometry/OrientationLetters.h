// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <glm/glm.hpp>

namespace ui {

/// The orientation letters of a direction in the patient: R L (right, left), A P (anterior,
/// posterior), S I (superior, inferior), the strongest first; "LPS" for an oblique one. Components
/// of less than about nine degrees are left out. (DICOM PS3.3 C.7.6.1.1.1 with S and I for H and
/// F.)
[[nodiscard]] QString directionLetters(const glm::dvec3& directionLps);

} // namespace ui

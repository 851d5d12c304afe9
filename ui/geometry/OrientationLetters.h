// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <glm/glm.hpp>

namespace ui {

/// Where a direction in the patient points, as readers write it: R L (right, left), A P (front,
/// back), S I (head, feet); the strongest first, "LPS" for a slanting one. Components of less than
/// about nine degrees are left out. (DICOM PS3.3 C.7.6.1.1.1 with S and I for H and F.)
[[nodiscard]] QString directionLetters(const glm::dvec3& directionLps);

} // namespace ui

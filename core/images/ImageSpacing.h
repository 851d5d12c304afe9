// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <glm/glm.hpp>

namespace core {

constexpr double millimetresPerMetre = 1000.0;
constexpr double millimetresPerInch = 25.4;

/// Sets distances along columns and rows from pixels per unit. 72 and 96 per inch are ignored,
/// since programs write them without knowing the resolution.
void setResolution(
    glm::dvec3& spacingMm, double columnsPerUnit, double rowsPerUnit, double millimetresPerUnit);

/// What ImageJ writes into the description of a TIFF's first page.
struct ImageJWords {
    bool isImageJ = false;
    int images = 1; ///< number of pages that it states
    int perPlace = 1; ///< channels × points in time: pages at the same position
    double millimetresPerUnit = 0.0; ///< 0: no unit of length is stated
    double spacing = 0.0; ///< of slices, in units; 0: not stated
};
[[nodiscard]] ImageJWords imageJWords(const QByteArray& description);

} // namespace core

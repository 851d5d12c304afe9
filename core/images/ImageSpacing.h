// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <glm/glm.hpp>

namespace core {

constexpr double millimetresPerMetre = 1000.0;
constexpr double millimetresPerInch = 25.4;

/// Distances along columns and rows from pixels per unit, where these mean something: 72 and 96
/// per inch are what programs write that know nothing.
void setResolution(
    glm::dvec3& spacingMm, double columnsPerUnit, double rowsPerUnit, double millimetresPerUnit);

/// What ImageJ writes in words into the description of a TIFF's first page.
struct ImageJWords {
    bool isImageJ = false;
    int images = 1; ///< pages that it speaks of
    int perPlace = 1; ///< channels × points in time: pages at the same place
    double millimetresPerUnit = 0.0; ///< 0: it names no length
    double spacing = 0.0; ///< of slices, in units; 0: not said
};
[[nodiscard]] ImageJWords imageJWords(const QByteArray& description);

} // namespace core

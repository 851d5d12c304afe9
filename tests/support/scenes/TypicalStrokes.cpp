// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/TypicalStrokes.h"

#include "core/edits/kinds/EditParts.h"
#include "tests/support/scenes/PlainEdits.h"

#include <cmath>

namespace test {

core::Edit typicalPaintStroke(
    int segment, const glm::dvec3& middleLps, core::BrushPath::Shape shape)
{
    constexpr int dabs = 60;
    constexpr double bends = 3.0;
    core::Edit stroke = paintAt(segment, {}, 8.0);
    core::BrushPath& path = *core::brushPathOf(stroke);
    path.shape = shape;
    if (shape == core::BrushPath::Shape::Disc)
        path.normalLps = glm::dvec3(0.0, 0.0, 1.0);
    for (int dab = 0; dab < dabs; ++dab) {
        const double along = double(dab) / (dabs - 1);
        path.pointsLps.push_back(middleLps
            + glm::dvec3(60.0 * (along - 0.5),
                20.0 * std::sin(2.0 * 3.14159265358979 * bends * along), 0.0));
    }
    return stroke;
}

} // namespace test

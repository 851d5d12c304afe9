// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/OrientationLetters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

QString directionLetters(const glm::dvec3& directionLps)
{
    constexpr double faintest = 0.16; // sin 9.2°
    constexpr char positive[] = "LPS";
    constexpr char negative[] = "RAI";
    const glm::dvec3 unit = glm::normalize(directionLps);
    std::array<int, 3> axes{0, 1, 2};
    // Equal components keep the order x, y, z in spite of rounding.
    std::stable_sort(axes.begin(), axes.end(),
        [&unit](int a, int b) { return std::abs(unit[a]) > std::abs(unit[b]) + 1e-9; });
    QString letters;
    for (const int axis : axes) {
        if (std::abs(unit[axis]) >= faintest)
            letters += QLatin1Char(unit[axis] > 0.0 ? positive[axis] : negative[axis]);
    }
    return letters;
}

} // namespace ui

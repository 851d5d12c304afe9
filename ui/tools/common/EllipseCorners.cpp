// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/EllipseCorners.h"

#include <cmath>
#include <numbers>

namespace ui {

std::vector<glm::dvec2> ellipseCorners(const glm::dvec2& centre, const glm::dvec2& half)
{
    constexpr int count = 256;
    std::vector<glm::dvec2> corners;
    corners.reserve(count);
    for (int corner = 0; corner < count; ++corner) {
        const double angle = 2.0 * std::numbers::pi * corner / count;
        corners.push_back(centre + half * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

} // namespace ui

// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/WindowMapping.h"

#include <algorithm>
#include <cmath>

namespace gpu {

glm::dvec2 valueOfTexel(const core::VoxelEncoding& encoding)
{
    const double first = encoding.value(0);
    return {(encoding.value(1) - first) * 65535.0, first};
}

glm::dvec2 greyOfTexel(const core::VoxelEncoding& encoding, const core::WindowLevel& window)
{
    const glm::dvec2 value = valueOfTexel(encoding);
    const GreyRamp ramp = greyRampOf(encoding, window);
    return {value.x / ramp.span, (value.y - ramp.middle) / ramp.span + 0.5};
}

double valuesApart(const core::VoxelEncoding& encoding)
{
    // The product itself: a difference of values would be rounded.
    return std::abs(encoding.rescaleSlope * double(encoding.storedStep));
}

GreyRamp greyRampOf(const core::VoxelEncoding& encoding, const core::WindowLevel& window)
{
    constexpr double leastSpan = 1e-30; // neither 0 nor beyond float
    if (valuesApart(encoding) != 1.0)
        return {.middle = window.centre, .span = std::max(window.width, leastSpan)};
    return {.middle = window.centre - 0.5, .span = std::max(window.width - 1.0, 1e-3)};
}

double leastWindowWidth(const core::VoxelEncoding& encoding)
{
    const double step = valuesApart(encoding);
    return step == 1.0 ? 1e-3 : step;
}

} // namespace gpu

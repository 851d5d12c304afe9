// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/WindowMapping.h"

#include <algorithm>

namespace gpu {

glm::dvec2 valueOfTexel(const core::VoxelEncoding& encoding)
{
    const double first = encoding.value(0);
    return {(encoding.value(1) - first) * 65535.0, first};
}

glm::dvec2 greyOfTexel(const core::VoxelEncoding& encoding, const core::WindowLevel& window)
{
    const glm::dvec2 value = valueOfTexel(encoding);
    const double span = std::max(window.width - 1.0, 1e-3);
    return {value.x / span, (value.y - (window.centre - 0.5)) / span + 0.5};
}

} // namespace gpu

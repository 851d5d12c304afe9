// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace gpu {

/// A box along the axes of the world, LPS millimetres; empty at first.
struct WorldBox {
    glm::dvec3 minimum{1e300};
    glm::dvec3 maximum{-1e300};

    [[nodiscard]] bool empty() const { return minimum.x > maximum.x; }
    void add(const glm::dvec3& lps)
    {
        minimum = glm::min(minimum, lps);
        maximum = glm::max(maximum, lps);
    }
};

} // namespace gpu

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/surface/SurfacePath.h"

#include <glm/glm.hpp>

namespace core {

/// A plane takes off what stands beyond it.
struct PlaneScrape {
    SurfacePath path{};
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< outwards, about a unit vector
};

} // namespace core

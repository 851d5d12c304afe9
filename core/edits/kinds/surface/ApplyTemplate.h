// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// What is red takes the shape of contours that were drawn on planes.
struct ApplyTemplate {
    std::vector<std::vector<glm::dvec3>> contoursLps{};
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// Shut the neck through which growth came to a place, and take back what lies beyond.
struct PlugLeak {
    glm::dvec3 pointLps{0.0};
};

} // namespace core

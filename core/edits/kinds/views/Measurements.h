// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Keep a distance that was measured: points at their true places.
struct AddMeasurement {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    std::optional<int> piece{}; ///< id of the one that both points were picked on
};

struct RemoveMeasurement {
    int measurement = 0; ///< id
};

} // namespace core

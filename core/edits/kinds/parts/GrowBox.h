// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// A box along the volume's axes, given by two opposite corners. It contains the voxels between
/// those nearest to the corners, inclusive.
struct GrowBox {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    bool operator==(const GrowBox&) const = default;
};

} // namespace core

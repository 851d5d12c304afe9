// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// A box with sides along the volume's axes, by two opposite corners: it holds the voxels between
/// those nearest to the corners, inclusive.
struct GrowBox {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    bool operator==(const GrowBox&) const = default;
};

} // namespace core

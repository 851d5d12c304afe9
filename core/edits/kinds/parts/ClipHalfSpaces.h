// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// A half-space that a clip plane or a side of the clip box hides without carving it: the places
/// with dot(normal, place) > offset.
struct ClipHalfSpace {
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< about a unit vector
    double offsetMm = 0.0;
    bool operator==(const ClipHalfSpace&) const = default;
};
/// What was hidden from an edit: a cut neither starts nor cuts there.
using ClipHalfSpaces = std::optional<std::vector<ClipHalfSpace>>;

} // namespace core

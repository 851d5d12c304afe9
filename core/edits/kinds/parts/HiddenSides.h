// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// Hidden are the places with dot(normal, place) > offset: what a clip box or plane hides without
/// carving it.
struct HiddenSide {
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< about a unit vector
    double offsetMm = 0.0;
    bool operator==(const HiddenSide&) const = default;
};
/// What an edit did not see: a cut neither starts nor cuts there.
using HiddenSides = std::optional<std::vector<HiddenSide>>;

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// Sketched seeds: the voxels nearest to these points.
struct SeedStroke {
    int segment = 0;
    std::vector<glm::dvec3> pointsLps{};
    /// Seeds that are taken away first, where no growth has accepted them; with as many points,
    /// they are moved.
    std::optional<std::vector<glm::dvec3>> takenLps{};
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/planes/PlaneSketch.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace reference {

/// Which voxels of the volume lie between the planes on which a label was drawn, whoever has them,
/// by the rules of core/morphology/planes/BetweenPlanes.h: every voxel of the volume is asked, each
/// distance is looked for among all pixels of a border, and products have 128 bits.
/// @param labels x fastest
[[nodiscard]] std::vector<bool> voxelsBetweenPlanes(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, const core::PlaneSketch& sketch);

} // namespace reference

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/SliceAxis.h"
#include "core/volume/VolumeGeometry.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace reference {

/// Which voxels of the volume lie between the drawn slices of a label, whoever has them, by the
/// rule of core/morphology/BetweenSlices.h: pixel by pixel, with distances that are looked for
/// among all pixels of a border and products in 128 bits, where core makes distance maps of
/// rectangles.
/// @param axis none: the one across which somebody has drawn
/// @param labels x fastest
[[nodiscard]] std::vector<bool> voxelsBetween(std::span<const std::uint8_t> labels,
    const core::VolumeGeometry& geometry, std::uint8_t label, std::optional<core::SliceAxis> axis);

} // namespace reference

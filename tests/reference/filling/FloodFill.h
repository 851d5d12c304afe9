// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/filling/FloodFill.h"
#include "core/volume/Volume.h"

#include <cstdint>
#include <span>
#include <vector>

namespace reference {

/// Which voxels hang together with the first one of a flood fill, by sweeping over the whole volume
/// until nothing joins, where core goes on from brick to brick; whoever has them.
/// @param labels of the segment's plane, x fastest
[[nodiscard]] std::vector<bool> floodedVoxels(const core::FloodFill& edit,
    const core::LoadedVolume& study, std::span<const std::uint8_t> labels);

} // namespace reference

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/MaskOnVolume.h"

#include <map>

namespace core {

struct ImportMask;

/// The segments of imported masks as they were imported, the newest mask first. A segment of an
/// older mask is left out if a newer mask has one of the same name. Cost ∝ the runs. Any thread.
/// @param imports in the order of the history, with their voxels
/// @param names present names of segments, by label: a mask that was imported into one segment
/// (ImportMask::as) appears under that segment's name
/// @param voxels number of voxels of the volume
[[nodiscard]] MaskOnVolume importedMasks(const std::vector<ImportMask>& imports,
    const std::map<int, QString>& names, std::uint64_t voxels);

} // namespace core

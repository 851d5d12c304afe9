// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ImportMask.h"
#include "core/masks/MaskOnVolume.h"

#include <map>

namespace core {

/// The segments of masks as they were imported, the newest mask first; a name that a newer one has
/// stands for the newer one. Cost ∝ their runs. Any thread.
/// @param imports in the order of the history, with their voxels
/// @param names by label: what was taken into one segment (ImportMask::as) has that segment's name
/// @param voxels of the volume
[[nodiscard]] MaskOnVolume importedMasks(const std::vector<ImportMask>& imports,
    const std::map<int, QString>& names, std::uint64_t voxels);

} // namespace core

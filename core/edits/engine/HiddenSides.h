// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/sculpt/HiddenHalf.h"
#include "core/volume/ClipRegion.h"

namespace core {

/// What a clip region hides, as edits name it; nothing where it is off.
[[nodiscard]] HiddenSides hiddenSides(const ClipRegion& region, const VolumeGeometry& geometry);

/// In an engine's integers. Doubles are used here and nowhere after.
[[nodiscard]] std::vector<HiddenHalf> hiddenHalves(
    const HiddenSides& hidden, const VolumeGeometry& geometry);

} // namespace core

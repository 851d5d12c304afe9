// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/sculpt/HiddenHalf.h"
#include "core/volume/ClipRegion.h"

namespace core {

/// The half-spaces that a clip region hides, as edits store them; none if it is off.
[[nodiscard]] HiddenSides hiddenSides(const ClipRegion& region, const VolumeGeometry& geometry);

/// The same in the integers of an engine. Doubles are used here and nowhere later.
[[nodiscard]] std::vector<HiddenHalf> hiddenHalves(
    const HiddenSides& hidden, const VolumeGeometry& geometry);

} // namespace core

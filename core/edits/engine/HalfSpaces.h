// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/sculpt/IntegerHalfSpace.h"
#include "core/volume/ClipRegion.h"

namespace core {

/// The half-spaces that a clip region hides, as edits store them; none if it is off.
[[nodiscard]] ClipHalfSpaces clipHalfSpaces(
    const ClipRegion& region, const VolumeGeometry& geometry);

/// The same in the integers of an engine. Doubles are used here and nowhere later.
[[nodiscard]] std::vector<IntegerHalfSpace> integerHalfSpaces(
    const ClipHalfSpaces& hidden, const VolumeGeometry& geometry);

} // namespace core

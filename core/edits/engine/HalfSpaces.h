// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/sculpt/IntegerHalfSpace.h"
#include "core/volume/ClipRegion.h"

namespace core {

/// The half-spaces outside a clip region, which it hides, in millimetres as edits store them; none
/// if the region is off.
[[nodiscard]] ClipHalfSpaces clipHalfSpaces(
    const ClipRegion& region, const VolumeGeometry& geometry);

/// The same in the integers of an engine. Floating-point numbers end here; the engine computes with
/// integers only.
[[nodiscard]] std::vector<IntegerHalfSpace> integerHalfSpaces(
    const ClipHalfSpaces& hidden, const VolumeGeometry& geometry);

} // namespace core

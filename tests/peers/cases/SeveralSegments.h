// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/cases/WholeSegments.h"

#include <vector>

namespace peer {

/// Operations that concern several segments: islands and sides of a plane that become segments,
/// merging, swapping and copying, set operations, and smoothing together.
[[nodiscard]] std::vector<WholeSegment> severalSegments();

/// How many voxels an island must have to become a segment, so that there are labels for all of
/// them.
[[nodiscard]] int leastIslandVoxels(const RealSegment& segment);

} // namespace peer

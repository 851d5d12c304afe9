// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/cases/WholeSegments.h"

#include <vector>

namespace peer {

/// Operations that concern several segments: islands that become segments, set operations, and
/// smoothing together.
[[nodiscard]] std::vector<WholeSegment> severalSegments();

} // namespace peer

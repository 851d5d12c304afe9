// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/cases/WholeSegments.h"

namespace peer {

/// A margin towards no side but up, front and right, half as far to the front, by which a segment
/// grows or shrinks.
[[nodiscard]] WholeSegment sidedMargin(bool grows);

} // namespace peer

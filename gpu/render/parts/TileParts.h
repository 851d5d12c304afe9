// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/TilePlan.h"

#include <vector>

namespace gpu {

/// Returns the intersection of two rectangles; of size 0 if it is empty.
[[nodiscard]] Tile commonPart(const Tile& a, const Tile& b);

/// Returns the smallest rectangle that contains two others.
[[nodiscard]] Tile unionOf(const Tile& a, const Tile& b);

/// Returns what is left of a tile without a rectangle inside it: at most four rectangles that do
/// not overlap.
/// @param hole of size 0: nothing is taken out
[[nodiscard]] std::vector<Tile> partsAround(const Tile& tile, const Tile& hole);

} // namespace gpu

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/TilePlan.h"

#include <vector>

namespace gpu {

/// The pixels that two rectangles share; of size 0 if they share none.
[[nodiscard]] Tile commonPart(const Tile& a, const Tile& b);

/// The smallest rectangle that holds two others.
[[nodiscard]] Tile unionOf(const Tile& a, const Tile& b);

/// What is left of a tile without a rectangle that lies within it: at most four rectangles, of
/// which none overlap.
/// @param hole of size 0: none, and the tile is left whole
[[nodiscard]] std::vector<Tile> partsAround(const Tile& tile, const Tile& hole);

} // namespace gpu

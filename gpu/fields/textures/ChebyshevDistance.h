// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// Chessboard distance, in cells, of every cell to the nearest occupied one; 0 where occupied, at
/// most 255. Cells x fastest, then y, then z. Exact: two sweeps with unit weights over the 26
/// neighbours (Borgefors 1986, chessboard case). Linear in the cells.
[[nodiscard]] std::vector<std::uint8_t> chebyshevDistance(
    const glm::ivec3& cells, std::span<const std::uint8_t> occupied);

} // namespace gpu

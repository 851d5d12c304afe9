// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkField.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace core {

/// A box with a border of one voxel on all sides, so that every voxel of the box has six
/// neighbours.
struct BorderedBox {
    glm::ivec3 size{0}; ///< without the border
    std::vector<std::uint16_t> codes;
    /// Before any is known: the most; 0 in the border and for what is left out, so that no path
    /// enters.
    std::vector<std::uint8_t> costs;

    explicit BorderedBox(const ChunkSource& source);
    [[nodiscard]] std::size_t row() const { return std::size_t(size.x) + 2; }
    [[nodiscard]] std::size_t slice() const { return row() * (std::size_t(size.y) + 2); }
    /// Where a row of the box begins.
    [[nodiscard]] std::size_t rowAt(int y, int z) const
    {
        return std::size_t(z + 1) * slice() + std::size_t(y + 1) * row() + 1;
    }
};

/// How strongly voxels are connected with one owner (rules 1 and 3 of ChunkField).
struct OwnerCosts {
    int mean = 0; ///< of its codes
    int spread = 1; ///< mean deviation from it, at least 1
    std::vector<std::uint32_t> cores{}; ///< in the bordered box

    /// The costs of all voxels of the bordered box, without meaning outside.
    /// @param noise as ChunkField::noise()
    /// @param goOn told now and then how many more voxels have their cost; false: it is given up
    [[nodiscard]] std::vector<std::uint8_t> of(
        const BorderedBox& box, int noise, const std::function<bool(std::size_t)>& goOn) const;
};

/// A difference in units of mean deviations, clamped.
[[nodiscard]] int inDeviations(int difference, int deviation);

} // namespace core

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
    /// The costs before any is known: the highest cost. 0 in the border and at voxels that are left
    /// out, so that no path enters them.
    std::vector<std::uint8_t> costs;

    explicit BorderedBox(const ChunkSource& source);
    [[nodiscard]] std::size_t row() const { return std::size_t(size.x) + 2; }
    [[nodiscard]] std::size_t slice() const { return row() * (std::size_t(size.y) + 2); }
    /// The index of the first voxel of a row of the box, border not included.
    [[nodiscard]] std::size_t rowAt(int y, int z) const
    {
        return std::size_t(z + 1) * slice() + std::size_t(y + 1) * row() + 1;
    }
};

/// Computes how strongly voxels are connected with one owner (rules 1 and 3 of ChunkField).
struct OwnerCosts {
    int mean = 0; ///< mean code of the owner's voxels
    int spread = 1; ///< mean absolute deviation from that, at least 1
    std::vector<std::uint32_t> cores{}; ///< voxels of the owner's core; indices in the bordered box

    /// The cost of every voxel of the bordered box for this owner; values in the border have no
    /// meaning.
    /// @param noise that of ChunkField::noise()
    /// @param goOn called now and then with the number of voxels that have got their cost since the
    /// last call; if it returns false, the computation stops and the result is incomplete
    [[nodiscard]] std::vector<std::uint8_t> of(
        const BorderedBox& box, int noise, const std::function<bool(std::size_t)>& goOn) const;
};

/// A difference of codes in units of mean deviations: ChunkField::deviation for each of them, at
/// most ChunkField::most.
[[nodiscard]] int inDeviations(int difference, int deviation);

} // namespace core

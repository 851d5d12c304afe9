// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>

namespace core {

/// A set of voxels of a brick: voxel v is bit v % 8 of byte v / 8.
struct BrickBits {
    std::array<std::uint8_t, BrickGrid::voxelsPerBrick / 8> bits{};

    [[nodiscard]] bool has(std::size_t voxel) const
    {
        return (bits[voxel / 8] >> (voxel % 8) & 1U) != 0;
    }
    void add(std::size_t voxel)
    {
        bits[voxel / 8] = std::uint8_t(bits[voxel / 8] | 1U << (voxel % 8));
    }
    [[nodiscard]] std::size_t count() const
    {
        std::size_t sum = 0;
        for (const std::uint8_t byte : bits)
            sum += std::bitset<8>(byte).count();
        return sum;
    }
    /// Calls @p visit for every voxel, ascending.
    template <typename Visit> void forEach(const Visit& visit) const
    {
        for (std::size_t byte = 0; byte < bits.size(); ++byte) {
            if (bits[byte] == 0)
                continue;
            for (std::size_t bit = 0; bit < 8; ++bit) {
                if ((bits[byte] >> bit & 1U) != 0)
                    visit(8 * byte + bit);
            }
        }
    }

    bool operator==(const BrickBits&) const = default;
};

} // namespace core

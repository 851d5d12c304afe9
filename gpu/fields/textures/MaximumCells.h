// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Texture3D.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace gpu {

/// The greatest code of cells of 4³ voxels, and how far it is to a cell that is greater than this
/// or that: what a maximum intensity projection looks at to leave out most of a ray. Finer than
/// MacroCells because a bound of a maximum must be tight to be of use. Cell c answers for samples
/// at index positions in [4c, 4c + 4) per axis. Engine thread.
///
/// About 1/8 byte a voxel; made in time linear in the voxels, a few nanoseconds each.
class MaximumCells {
public:
    static constexpr int side = 4;
    static constexpr int levelCount = 6;

    MaximumCells() = default;
    MaximumCells(const glm::ivec3& volumeSize, std::span<const std::uint16_t> codes);

    [[nodiscard]] glm::ivec3 cells() const { return m_texture.size(); }
    /// Ascending codes. Distance k is to the nearest cell whose greatest code exceeds level k.
    [[nodiscard]] const std::array<int, levelCount>& levels() const { return m_levels; }
    /// RGBA16UI: greatest code; Chebyshev distances in cells, a byte each: level 0 in the low and 1
    /// in the high byte of the second word, and so on.
    [[nodiscard]] const Texture3D& texture() const { return m_texture; }

    [[nodiscard]] static glm::ivec3 cellsFor(const glm::ivec3& volumeSize);
    [[nodiscard]] static std::size_t bytesFor(const glm::ivec3& volumeSize); ///< of GPU memory

private:
    std::array<int, levelCount> m_levels{};
    Texture3D m_texture;
};

} // namespace gpu

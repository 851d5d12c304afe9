// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickBytes.h"

#include <glm/glm.hpp>

#include <compare>
#include <cstdint>

namespace core {

/// A box of voxels: minimum included, maximum excluded.
struct VoxelBox {
    glm::ivec3 minimum{0};
    glm::ivec3 maximum{0}; ///< one past the last voxel

    [[nodiscard]] bool empty() const;
    [[nodiscard]] VoxelBox united(const VoxelBox& other) const;
};

/// The grid of 16³ bricks that covers a volume. A brick is the unit of edit, undo, hash and upload.
///
/// Bricks are numbered x fastest, then y, then z. Inside a brick voxels run x fastest too. Voxels
/// of a border brick that lie outside the volume always hold the field's empty value.
struct BrickGrid {
    static constexpr int side = 16;
    static constexpr int voxelsPerBrick = side * side * side;

    glm::ivec3 volumeSize{0};

    [[nodiscard]] glm::ivec3 bricks() const { return (volumeSize + (side - 1)) / side; }
    [[nodiscard]] int brickCount() const;
    [[nodiscard]] int brickOf(const glm::ivec3& voxel) const;
    [[nodiscard]] glm::ivec3 brickPosition(int brick) const; ///< in bricks
    [[nodiscard]] VoxelBox boxOf(int brick) const; ///< clipped to the volume
    /// Offset of a voxel inside its brick, 0 … 4095.
    [[nodiscard]] static int offsetInBrick(const glm::ivec3& voxel);
};

/// What is stored per voxel and edited (DESIGN §4).
enum class Field : std::uint8_t {
    Coverage = 1, ///< one byte, empty 0; `plane` names the sculpt layer
    Labels = 2, ///< one byte, empty 0; `plane` names the label plane
    SeedWords = 3, ///< four bytes little-endian, empty 0xFFFFFFFF; `plane` names the label plane
    /// One byte, empty 0; `plane` names the label plane: the label that growth overwrote
    /// (growth/GrowthCommands.h).
    Overwritten = 4,
};

[[nodiscard]] int bytesPerVoxel(Field field);
[[nodiscard]] std::uint8_t emptyByte(Field field);

/// Names one brick of one field.
struct BrickKey {
    Field field = Field::Coverage;
    std::uint8_t plane = 0;
    std::uint32_t brick = 0;

    auto operator<=>(const BrickKey&) const = default;
};

/// The voxels of one brick; no bytes at all means that every voxel is empty.
struct BrickImage {
    BrickKey key;
    BrickBytes bytes;
};

/// One brick that an edit changed; before and after always differ.
struct BrickChange {
    BrickKey key;
    BrickBytes before;
    BrickBytes after;
};

} // namespace core

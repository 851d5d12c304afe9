// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/voxels/BoxMask.h"

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// A mask as a field whose level ½ is its smooth boundary.
///
/// At voxel centres: the mask filtered with [1 2 1]/4 along each axis, sharpened so that round
/// shapes do not shrink (2 G − G G), in integers; then kept at least 3/16 on its own side of ½, so
/// that each centre is inside or outside as its voxel is, even for single voxels and thin sheets.
/// Linear between centres. Any thread may read.
class SmoothOccupancy {
public:
    explicit SmoothOccupancy(const BoxMask& mask);

    /// From 0 outside to 1 inside; slightly outside this range near the boundary.
    [[nodiscard]] double at(const glm::dvec3& index) const;
    /// The gradient along the index axes.
    [[nodiscard]] glm::dvec3 rise(const glm::dvec3& index) const;

private:
    static constexpr int edge = 8;
    static constexpr int voxelsPerBrick = edge * edge * edge;
    static constexpr std::int16_t one = 4096;
    static constexpr std::int16_t leastOff = 3 * one / 16;
    using Brick = std::array<std::int16_t, voxelsPerBrick>;
    /// Entries of the table for bricks of one value.
    enum Uniform : std::int32_t { Outside = -1, Inside = -2 };

    /// The eight centres around a place, and the position between them.
    struct Cell {
        std::array<double, 8> corners{}; ///< x, then y, then z
        glm::dvec3 share{0.0};
    };
    [[nodiscard]] Cell cellAt(const glm::dvec3& index) const;
    [[nodiscard]] double valueAt(const glm::ivec3& voxel) const;

    glm::ivec3 m_first{0};
    glm::ivec3 m_bricksAlong{0};
    std::vector<std::int32_t> m_table;
    std::vector<Brick> m_bricks;
};

} // namespace core

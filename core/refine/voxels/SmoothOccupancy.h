// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/voxels/BoxMask.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
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
    [[nodiscard]] double at(const glm::dvec3& index) const { return Walk(*this).at(index); }
    /// The gradient along the index axes.
    [[nodiscard]] glm::dvec3 rise(const glm::dvec3& index) const;

private:
    using Corners = std::array<double, 8>; ///< x, then y, then z

public:
    /// Reads the field at places that lie close to one another: the centres around the last place
    /// are kept, and read again only for a place between others.
    class Walk {
    public:
        explicit Walk(const SmoothOccupancy& field)
            : m_field(field)
        {
        }
        [[nodiscard]] double at(const glm::dvec3& index);

    private:
        const SmoothOccupancy& m_field;
        glm::ivec3 m_first{std::numeric_limits<int>::min()};
        Corners m_corners{};
    };

private:
    static constexpr int edge = 8;
    /// A brick also holds the first voxels of those beyond it, so that the eight centres around a
    /// place are always found in one brick.
    static constexpr int stored = edge + 1;
    static constexpr int voxelsPerBrick = stored * stored * stored;
    static constexpr std::int16_t one = 4096;
    static constexpr std::int16_t leastOff = 3 * one / 16;
    using Brick = std::array<std::int16_t, voxelsPerBrick>;
    /// Entries of the table for bricks of one value.
    enum Uniform : std::int32_t { Outside = -1, Inside = -2 };

    /// The least of the eight centres around a place, counted from m_first, and how far the place
    /// is from it.
    struct Place {
        glm::ivec3 first{0};
        glm::dvec3 share{0.0};
    };
    [[nodiscard]] Place placeOf(const glm::dvec3& index) const;
    [[nodiscard]] Corners cornersAt(const glm::ivec3& first) const;
    /// Of a voxel counted from m_first, wherever it lies.
    [[nodiscard]] double valueAt(const glm::ivec3& voxel) const;
    [[nodiscard]] std::int32_t entryOf(int brickX, int brickY, int brickZ) const
    {
        return m_table[std::size_t((brickZ * m_bricksAlong.y + brickY) * m_bricksAlong.x + brickX)];
    }

    glm::ivec3 m_first{0};
    glm::ivec3 m_bricksAlong{0};
    std::vector<std::int32_t> m_table;
    std::vector<std::unique_ptr<const Brick>> m_bricks; ///< each by itself: none is copied
};

} // namespace core

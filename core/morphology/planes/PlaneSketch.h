// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace core {

/// Planes of any direction on which a segment was drawn, in integers: what lies between them
/// (BetweenPlanes.h) follows from these numbers and the labels alone.
///
/// Lengths are in *units*, of which the volume's diagonal has at most 2²⁶. Coordinates of a plane
/// are x to the right and y up in it, from the foot of voxel (0, 0, 0), and z the height above it.
struct PlaneSketch {
    /// Upper bounds of the numbers that occur.
    static constexpr int unitBits = 26;
    static constexpr std::size_t mostPlanes = 128;

    using Fixed3 = std::array<std::int64_t, 3>;

    struct Plane {
        // Coordinates of voxel (0, 0, 0) and their change per voxel, units · 2¹⁴. Along the axis
        // of the columns the height grows.
        Fixed3 origin{};
        std::array<Fixed3, 3> perVoxel{};
        /// The index axis that is nearest to the normal. Voxels along it form a column, of which
        /// the plane takes exactly one, where it meets the column at all.
        int along = 2;
        /// Distance between neighbouring pixels to the right and up, units. Pixel (x, y) lies at
        /// (x·pitch.x, y·pitch.y).
        glm::i64vec2 pitch{1};
        glm::ivec2 begin{0}; ///< the first pixel
        glm::ivec2 end{0}; ///< one beyond the last pixel; the outermost ones lie off the volume
        /// The column of pixel (0, 0), as the indices of the two other axes in ascending order, and
        /// its change per pixel to the right and up, · 2³⁰.
        std::array<std::int64_t, 2> column{};
        std::array<std::int64_t, 2> columnPerRight{};
        std::array<std::int64_t, 2> columnPerUp{};
    };
    /// The position of a plane relative to another one.
    struct Meeting {
        std::int64_t cosine = 0; ///< of the angle between their normals, · 2³⁰
        /// Whether the angle is large enough for the line in which they meet to matter. If not, the
        /// members below are 0.
        bool crosses = false;
        /// The direction in this plane at right angles to that line, to where the other plane's
        /// height grows, · 2³⁰.
        std::array<std::int64_t, 2> away{};
        std::int64_t offset = 0; ///< of the origin from that line in that direction, units
    };
    std::vector<Plane> planes{};
    std::vector<Meeting> meetings{}; ///< of plane i to plane j: at i·planes + j

    [[nodiscard]] const Meeting& meeting(std::size_t one, std::size_t other) const
    {
        return meetings[one * planes.size() + other];
    }
};

} // namespace core

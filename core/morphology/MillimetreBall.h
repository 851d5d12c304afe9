// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

struct VolumeGeometry;

/// A ball of millimetres on a volume's grid, in whole numbers. A step between two voxel centres is
/// in the ball if its squared length is at most the squared radius; a step and the opposite one are
/// in it together.
///
/// The squared length of a step (dx, dy, dz) is the quadratic form of the products of the grid's
/// axes, so a sheared grid (gantry tilt) is measured as it lies in the patient. Millimetres become
/// integers once, in ballOf(): the unit is the power of two that keeps every squared length below
/// 2⁶⁰, and the squared radius gets a millionth more, so that a radius of exactly three voxels
/// reaches the third one. Like every edit it measures by the affine; slices that deviate from it
/// (VolumeGeometry::slicePositions) lie where the affine puts them.
struct MillimetreBall {
    std::int64_t xx = 1; ///< products of the axes
    std::int64_t yy = 1;
    std::int64_t zz = 1;
    std::int64_t xy = 0; ///< 0, like the next two, where axes are at right angles to 0.01°
    std::int64_t xz = 0;
    std::int64_t yz = 0;
    std::int64_t squaredRadius = 0;
    glm::ivec3 extent{0}; ///< no step of the ball is longer along an axis; at least 1

    [[nodiscard]] bool isStraight() const { return xy == 0 && xz == 0 && yz == 0; }
    [[nodiscard]] std::int64_t squared(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return xx * x * x + yy * y * y + zz * z * z + 2 * (xy * x * y + xz * x * z + yz * y * z);
    }
    [[nodiscard]] bool holds(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return squared(x, y, z) <= squaredRadius;
    }
};

/// @pre mostBallVoxels() is not exceeded
[[nodiscard]] MillimetreBall ballOf(const VolumeGeometry& geometry, double radiusMm);

/// A ball has at most so many voxels from its centre along an axis; a radius with more is refused.
constexpr int mostBallVoxels = 4096;
/// How many it would have along the axis where they are most.
[[nodiscard]] double ballVoxels(const VolumeGeometry& geometry, double radiusMm);

/// The ball's steps along x for one step along y and z.
struct BallRow {
    int y = 0;
    int z = 0;
    int from = 0;
    int to = 0; ///< included
};
/// Those rows of the ball that two voxels of a box can have between them, z first.
[[nodiscard]] std::vector<BallRow> ballRows(const MillimetreBall& ball, const glm::ivec3& box);
/// The voxels of the whole ball.
[[nodiscard]] std::int64_t voxelCount(const MillimetreBall& ball);

} // namespace core

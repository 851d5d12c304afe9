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
/// The squared length of a step (dx, dy, dz) is computed from the scalar products of the grid's
/// axes, so distances on a sheared grid (gantry tilt) are those in the patient. Millimetres become
/// integers once, in ballOf(): the unit is the power of two that keeps every squared length below
/// 2⁶⁰. The squared radius is enlarged by a millionth, so that a radius of exactly three voxels
/// reaches the third one. As in every edit, distances are those of the affine indexToWorld, even if
/// the slices of the volume deviate from it (VolumeGeometry::slicePositions).
struct MillimetreBall {
    std::int64_t xx = 1; ///< scalar products of the grid's axes
    std::int64_t yy = 1;
    std::int64_t zz = 1;
    /// This and the next two are 0 if the axes are perpendicular to within 0.01°.
    std::int64_t xy = 0;
    std::int64_t xz = 0;
    std::int64_t yz = 0;
    std::int64_t squaredRadius = 0;
    /// The longest step of the ball along each axis at most, in voxels; at least 1.
    glm::ivec3 extent{0};
    /// Along these axes nothing lies beside a voxel: no step leads there, and the ball is a disc.
    glm::bvec3 isFlat{false};

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

/// Makes a ball for a grid.
/// @pre ballVoxels() is at most mostBallVoxels
[[nodiscard]] MillimetreBall ballOf(const VolumeGeometry& geometry, double radiusMm);

/// The same as a disc where the grid has a single slice, or a single row or column.
[[nodiscard]] MillimetreBall flatBallOf(const VolumeGeometry& geometry, double radiusMm);

/// The greatest number of voxels that a ball may reach from its centre along an axis; greater radii
/// are refused.
constexpr int mostBallVoxels = 4096;
/// How many voxels a ball of this radius would reach, along the axis on which they are most.
[[nodiscard]] double ballVoxels(const VolumeGeometry& geometry, double radiusMm);

/// The steps along x that are in the ball, for one step along y and z.
struct BallRow {
    int y = 0;
    int z = 0;
    int from = 0;
    int to = 0; ///< included
};
/// The rows of the ball that can lie between two voxels of a box of this size; ascending by z, then
/// y.
[[nodiscard]] std::vector<BallRow> ballRows(const MillimetreBall& ball, const glm::ivec3& box);
/// The number of voxels of the whole ball.
[[nodiscard]] std::int64_t voxelCount(const MillimetreBall& ball);

} // namespace core

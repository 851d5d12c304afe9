// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace core {

struct VolumeGeometry;

/// How far a margin reaches towards each of the patient's sides, in millimetres.
struct SixMargins {
    double right = 0.0;
    double left = 0.0;
    double anterior = 0.0;
    double posterior = 0.0;
    double inferior = 0.0;
    double superior = 0.0;
};

/// A body on a volume's grid, in whole numbers, that reaches differently far to each side: it
/// consists of one octant each of eight ellipsoids. A step is in it if the squares of its three
/// components, each divided by the margin on that side, add up to at most one. Towards a side
/// without a margin it is flat.
///
/// Each direction of the patient is represented by the axis of the grid, forwards or backwards,
/// that lies nearest to it; the three axes are assigned together, so that the cosines of their
/// angles have the greatest sum. On an oblique or sheared grid margins are measured along the
/// grid's axes. Millimetres become integers once, in sidedBallOf(): the squared ratio of one step
/// to the margin, in the unit that keeps every sum below 2⁶¹. The limit is enlarged by a millionth,
/// so that a margin of exactly three voxels reaches the third one.
struct SidedBall {
    /// For each axis, the squared ratio of one voxel to the margin backwards (0) and forwards (1)
    /// along it; more than `whole` if not even one voxel fits.
    std::array<std::array<std::int64_t, 2>, 3> squared{};
    std::int64_t whole = 0;
    glm::ivec3 before{0}; ///< the greatest number of voxels backwards along each axis
    glm::ivec3 behind{0}; ///< and forwards
};

/// The axis of the grid that represents each axis of the patient (x, y and z of LPS), chosen as
/// described at SidedBall.
[[nodiscard]] std::array<int, 3> axesOfPatient(const VolumeGeometry& geometry);

/// Makes a body for a grid.
/// @pre ballVoxels() of the greatest margin is at most mostBallVoxels
[[nodiscard]] SidedBall sidedBallOf(const VolumeGeometry& geometry, const SixMargins& margins);
/// The body mirrored at its centre: it contains the opposite steps.
[[nodiscard]] SidedBall reversed(const SidedBall& ball);

} // namespace core

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

/// A body of eight octants of ellipsoids on a volume's grid, in whole numbers: a step is in it if
/// its three parts, each as a share of the margin on that side, have squares that add up to one at
/// most. Towards a side without a margin it is flat.
///
/// Each of the patient's directions is that axis of the grid, forwards or backwards, that lies
/// nearest to it; all three axes together are chosen so that the cosines of their angles add up to
/// most. On an oblique or sheared grid margins are measured along its own axes. Millimetres become
/// integers once, in sidedBallOf(): the square of one step as a share of the margin, in the unit
/// that keeps every sum below 2⁶¹. The whole gets a millionth more, so that a margin of exactly
/// three voxels reaches the third one.
struct SidedBall {
    /// Of a step of one voxel against each axis of the grid (0) and along it (1); more than `whole`
    /// where none fits.
    std::array<std::array<std::int64_t, 2>, 3> squared{};
    std::int64_t whole = 0;
    glm::ivec3 before{0}; ///< how many steps fit against each axis, at most
    glm::ivec3 behind{0}; ///< and along it
};

/// Which of the grid's axes stands for each of the patient's, x, y and z of LPS, as above.
[[nodiscard]] std::array<int, 3> axesOfPatient(const VolumeGeometry& geometry);

/// @pre ballVoxels() of the greatest margin is at most mostBallVoxels
[[nodiscard]] SidedBall sidedBallOf(const VolumeGeometry& geometry, const SixMargins& margins);
/// The same steps backwards.
[[nodiscard]] SidedBall reversed(const SidedBall& ball);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// The grids of numbers that decide voxels. Such a number is rounded once, when a recipe or the pen
/// provides it; recipe, session and replay then have the same value bit by bit.
namespace quantum {

constexpr double perMillimetre = 1024.0; ///< positions, radii, depths: multiples of 1/1024 mm
constexpr double perCubicMillimetre = 1048576.0; ///< volumes: multiples of 2⁻²⁰ mm³
constexpr double perDirection = 1048576.0; ///< components of a direction: multiples of 2⁻²⁰
constexpr double perPressure = 65535.0; ///< pressure: multiples of 1/65535
constexpr double perDegree = 1024.0; ///< rotations of pieces
constexpr double perZoom = 1024.0; ///< of pieces
constexpr double perSecond = 10000.0; ///< time: multiples of 0.1 ms
// Modality values (bounds, thresholds) are not rounded: an exact search converts them to integer
// codes (VoxelEncoding), and JSON stores every double exactly.

constexpr double reachMm = 100000.0; ///< no position is farther away
constexpr double unbounded = 1e300; ///< the range of modality values

} // namespace quantum

} // namespace core

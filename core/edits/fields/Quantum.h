// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// The grids on which numbers that decide voxels lie (DESIGN §3.2). Numbers are rounded once, where
/// the recipe or the pen enters; recipe, session and replay then hold the same form, to the bit.
namespace quantum {

constexpr double perMillimetre = 1024.0; ///< positions, radii, depths: multiples of 1/1024 mm
constexpr double perDirection = 1048576.0; ///< components of a direction: multiples of 2⁻²⁰
constexpr double perPressure = 65535.0; ///< pressure: multiples of 1/65535
constexpr double perDegree = 1024.0; ///< turns of pieces
constexpr double perZoom = 1024.0; ///< of pieces
constexpr double perSecond = 10000.0; ///< time: multiples of 0.1 ms
// Modality values (bounds, thresholds) are not rounded: they become integer codes by an exact
// search (VoxelEncoding), and JSON holds every double exactly.

constexpr double reachMm = 100000.0; ///< no position lies farther out
constexpr double unbounded = 1e300; ///< the range of modality values

} // namespace quantum

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace core::radiation {

/// The exact integer form of seed A's Gaussian point radiation, R = 3 voxels (DESIGN §4).
///
/// For a field of bytes c (coverage of the composed layers; or 255 where a shown segment is and 0
/// elsewhere) the blur is B = (Σ c·w_x·w_y·w_z + 2²³) >> 24 with the weights below along each axis,
/// one unsigned 32-bit sum without intermediate rounding (255·2²⁴ + 2²³ < 2³²); voxels outside the
/// volume count as 0. The radiation of a voxel is then
///
///   not a member (c < 128):  min(B, 127)
///   a member (c ≥ 128):      max(B, 128), and where M, the greatest B of the 3×3×3 voxels around
///                            (and including) it that lie inside the volume, is below thinBelow,
///                            at least
///                            128 + thinLift·(thinBelow − M) / thinBelow
///
/// so that "≥ 128" equals membership at every voxel centre, and parts thinner than about three
/// voxels, which the blur alone would lose, keep a drawn half-width of about 0.4 voxel or more,
/// while flat and gently curved surfaces are left as the blur has them (there M ≥ thinBelow).
constexpr int radius = 3;
constexpr std::array<std::uint32_t, 7> weights{4, 21, 60, 86, 60, 21, 4};
constexpr int thinBelow = 192;
constexpr int thinLift = 88;
/// Radiation within this distance (per axis) of a changed voxel may change: blur plus the 3×3×3.
constexpr int reach = radius + 1;

} // namespace core::radiation

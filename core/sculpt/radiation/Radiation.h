// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace core::radiation {

/// The exact integer form of seed A's Gaussian point radiation, R = 3 voxels: a smooth field whose
/// level 128 is the surface that is drawn and cut.
///
/// For a field of bytes c (the coverage of the composed layers; or 255 inside shown segments and 0
/// elsewhere) the blur is B = (Σ c·w_x·w_y·w_z + 2²³) >> 24 with the weights below along each axis.
/// It is one unsigned 32-bit sum without intermediate rounding (255·2²⁴ + 2²³ < 2³²); voxels
/// outside the volume count as 0. The radiation of a voxel is then
///
///   not a member (c < 128):  min(B, 127)
///   a member (c ≥ 128):      max(B, 128), and at least
///                            128 + thinLift·(thinBelow − M) / thinBelow
///                            if M < thinBelow, where M is the greatest B of those of the 3×3×3
///                            voxels around it (including itself) that lie inside the volume.
///
/// So "≥ 128" equals membership at every voxel centre. Parts thinner than about three voxels, which
/// the blur alone would lose, are drawn with a half-width of about 0.4 voxel or more, while flat
/// and gently curved surfaces stay as the blur has them (there M ≥ thinBelow).
constexpr int radius = 3;
constexpr std::array<std::uint32_t, 7> weights{4, 21, 60, 86, 60, 21, 4};
constexpr int thinBelow = 192;
constexpr int thinLift = 88;
/// The distance per axis within which a changed voxel may change radiation: blur plus the 3×3×3.
constexpr int reach = radius + 1;

} // namespace core::radiation

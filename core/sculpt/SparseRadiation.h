// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace core::radiation {

/// Seed A's point radiation of sparse points (§3.1), in integers: each point adds a Gaussian of
/// height 1 around itself, so that a single one reaches 1 (masks and brushes, which fill, are
/// gathered instead: Radiation.h). The sum does not depend on the order of the points.
///
/// A footprint is separable, 2D × 1D. Along an axis with radius r (voxels) a point at p weighs a
/// voxel at v, |v − p| ≤ r, by w(v − p) = exp(−(v − p)² / 2σ²), σ = r / 2.5, rounded to 2⁻²⁸. At a
/// voxel it counts c = (((w_x·w_y >> 28)·w_z >> 28) + 2⁷) >> 8, in units of 2⁻²⁰. With the sum S of
/// all c the radiation is (min(S, 2²⁰)·255 + 2¹⁹) >> 20, a byte.
///
/// Sums are of 32 bits: at a voxel points may add up to 4095, unclamped. Points in voxels of their
/// own never add up to more than 520.
constexpr int smallestSparseRadius = 1;
constexpr int greatestSparseRadius = 8;
constexpr int sparseRadius = 3;
constexpr std::uint32_t sparseWeightBits = 28;
constexpr std::uint32_t sparseSumBits = 20;

/// What one point adds to the voxels first … first + count − 1.
struct SparseFootprint {
    static constexpr std::size_t longest = 2 * greatestSparseRadius + 1;

    glm::ivec3 first{0};
    glm::ivec3 count{0};
    std::array<std::array<std::uint32_t, longest>, 3> weights{}; ///< per axis, from first on
};

/// Radii along the axes of the grid for a ball of `radius` voxels of the finest spacing. An axis
/// that is coarser gets less, to 1/256 voxel, but never less than one: its own must be reached.
[[nodiscard]] glm::dvec3 sparseRadii(int radius, const glm::dvec3& spacingMm);

/// @param index voxel centres at integers; taken to the nearest 1/256 voxel
/// @param radii each 1 … 8 voxels
[[nodiscard]] SparseFootprint sparseFootprint(const glm::dvec3& index, const glm::dvec3& radii);

/// What one footprint adds at a voxel, in units of 2⁻²⁰.
[[nodiscard]] std::uint32_t sparseContribution(
    const SparseFootprint& footprint, const glm::ivec3& voxel);

/// The byte of a sum.
[[nodiscard]] constexpr std::uint8_t sparseByte(std::uint32_t sum)
{
    constexpr std::uint32_t one = 1u << sparseSumBits;
    return std::uint8_t(((sum < one ? sum : one) * 255u + one / 2) >> sparseSumBits);
}

} // namespace core::radiation

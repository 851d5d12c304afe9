// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace core::radiation {

/// Seed A's point radiation of sparse points (§3.1), in integers. Each point adds a Gaussian of
/// height 1 around itself, so that a single point reaches 1; dense masks and brushes use
/// Radiation.h instead. The sum does not depend on the order of the points.
///
/// A footprint is separable, 2D × 1D. Along an axis with radius r (voxels) a point at p gives a
/// voxel at v, |v − p| ≤ r, the weight w(v − p) = exp(−(v − p)² / 2σ²), σ = r / 2.5, rounded to
/// 2⁻²⁸. Its contribution at a voxel is c = (((w_x·w_y >> 28)·w_z >> 28) + 2⁷) >> 8, in units of
/// 2⁻²⁰. With S the sum of all c, the radiation is (min(S, 2²⁰)·255 + 2¹⁹) >> 20, a byte.
///
/// Sums have 32 bits, so points may add up to 4095 at a voxel before they are clamped. Points in
/// different voxels never add up to more than 520.
constexpr int smallestSparseRadius = 1;
constexpr int greatestSparseRadius = 8;
constexpr int sparseRadius = 3;
constexpr std::uint32_t sparseWeightBits = 28;
constexpr std::uint32_t sparseSumBits = 20;

/// The weights of one point for the voxels first … first + count − 1.
struct SparseFootprint {
    static constexpr std::size_t longest = 2 * greatestSparseRadius + 1;

    glm::ivec3 first{0};
    glm::ivec3 count{0};
    std::array<std::array<std::uint32_t, longest>, 3> weights{}; ///< per axis, from first on
};

/// Radii along the axes of the grid for a ball of `radius` voxels of the finest spacing. A coarser
/// axis has a smaller radius, rounded to 1/256 voxel, but at least one voxel, so that its own voxel
/// is included.
[[nodiscard]] glm::dvec3 sparseRadii(int radius, const glm::dvec3& spacingMm);

/// @param index position with voxel centres at integers; rounded to the nearest 1/256 voxel
/// @param radii each 1 … 8 voxels
[[nodiscard]] SparseFootprint sparseFootprint(const glm::dvec3& index, const glm::dvec3& radii);

/// The contribution of one footprint at a voxel, in units of 2⁻²⁰.
[[nodiscard]] std::uint32_t sparseContribution(
    const SparseFootprint& footprint, const glm::ivec3& voxel);

/// The radiation for a sum S.
[[nodiscard]] constexpr std::uint8_t sparseByte(std::uint32_t sum)
{
    constexpr std::uint32_t one = 1u << sparseSumBits;
    return std::uint8_t(((sum < one ? sum : one) * 255u + one / 2) >> sparseSumBits);
}

} // namespace core::radiation

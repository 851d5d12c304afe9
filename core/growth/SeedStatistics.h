// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// What the codes around the seeds of one label add up to. A voxel that is near several seeds
/// counts for each.
struct SeedSums {
    std::uint64_t voxels = 0;
    std::uint64_t codes = 0;
    std::uint64_t squares = 0; ///< of codes
    bool operator==(const SeedSums&) const = default;
};

/// How far from a seed along each axis voxels count: 7³ around it.
constexpr int seedReach = 3;

/// Mean and standard deviation of codes, in 256ths of a code, rounded down; both 0 of nothing.
///
/// With c = codes div voxels, r = codes − voxels · c and s = Σ (code − c)²: mean = 256 · c +
/// ⌊⌊4096 · r / voxels⌋ / 16⌋, and deviation = ⌊√(⌊2¹⁶ · s / voxels⌋ − ⌊⌊4096 · r / voxels⌋² /
/// 2⁸⌋)⌋, in which no 64-bit number overflows for up to 2³¹ voxels.
struct SeedSpread {
    std::int64_t mean256 = 0;
    std::int64_t deviation256 = 0;
};
[[nodiscard]] SeedSpread seedSpread(const SeedSums& sums);

/// Codes from low to high, none if low > high.
struct CodeInterval {
    int low = 1;
    int high = 0;
    bool operator==(const CodeInterval&) const = default;
};

/// The codes of which 256 times lie within ⌊sigmas256 · deviation256 / 256⌋ of the mean; none where
/// there are no voxels.
/// @param sigmas256 256ths of a standard deviation, 0 … 25600
[[nodiscard]] CodeInterval seedInterval(const SeedSums& sums, int sigmas256);

} // namespace core

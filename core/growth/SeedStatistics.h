// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// Sums of the codes around the seeds of one label. A voxel near several seeds counts once for
/// each.
struct SeedSums {
    std::uint64_t voxels = 0;
    std::uint64_t codes = 0;
    std::uint64_t squares = 0; ///< of codes
    bool operator==(const SeedSums&) const = default;
};

/// How far from a seed, in voxels along each axis, codes are counted: 7³ voxels around it.
constexpr int seedReach = 3;

/// Mean and standard deviation of codes in 256ths of a code, rounded down; both 0 without voxels.
///
/// With c = codes div voxels, r = codes − voxels · c and s = Σ (code − c)²: mean = 256 · c +
/// ⌊⌊4096 · r / voxels⌋ / 16⌋, and deviation = ⌊√(⌊2¹⁶ · s / voxels⌋ − ⌊⌊4096 · r / voxels⌋² /
/// 2⁸⌋)⌋, in which no 64-bit number overflows for up to 2³¹ voxels.
struct SeedMoments {
    std::int64_t mean256 = 0;
    std::int64_t deviation256 = 0;
};
[[nodiscard]] SeedMoments seedMoments(const SeedSums& sums);

/// Codes from low to high, both included; empty if low > high.
struct CodeInterval {
    int low = 1;
    int high = 0;
    bool operator==(const CodeInterval&) const = default;
};

/// The codes that, multiplied by 256, differ from the mean by at most
/// ⌊sigmas256 · deviation256 / 256⌋; empty without voxels.
/// @param sigmas256 256ths of a standard deviation, 0 … 25600
[[nodiscard]] CodeInterval seedInterval(const SeedSums& sums, int sigmas256);

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedStatistics.h"

#include <algorithm>

namespace core {

namespace {

/// ⌊√x⌋, digit by digit.
std::uint64_t root(std::uint64_t x)
{
    std::uint64_t result = 0;
    for (std::uint64_t bit = std::uint64_t(1) << 62; bit != 0; bit >>= 2) {
        if (x >= result + bit) {
            x -= result + bit;
            result = (result >> 1) + bit;
        } else {
            result >>= 1;
        }
    }
    return result;
}

std::int64_t divideDown(std::int64_t number, std::int64_t by)
{
    return number >= 0 ? number / by : -((-number + by - 1) / by);
}

} // namespace

SeedMoments seedMoments(const SeedSums& sums)
{
    const std::uint64_t n = sums.voxels;
    if (n == 0)
        return {};
    const std::uint64_t whole = sums.codes / n;
    const std::uint64_t rest = sums.codes - n * whole;
    // Modulo 2⁶⁴ on the way; the sum of squared distances itself is far below.
    const std::uint64_t squares = sums.squares - 2 * whole * sums.codes + n * whole * whole;
    const std::uint64_t rest4096 = 4096 * rest / n;
    const std::uint64_t meanSquare = 65536 * (squares / n) + 65536 * (squares % n) / n;
    const std::uint64_t variance = meanSquare - (rest4096 * rest4096 >> 8);
    return {.mean256 = std::int64_t(256 * whole + rest4096 / 16),
        .deviation256 = std::int64_t(root(variance))};
}

CodeInterval seedInterval(const SeedSums& sums, int sigmas256)
{
    if (sums.voxels == 0)
        return {};
    const SeedMoments spread = seedMoments(sums);
    const std::int64_t reach = (sigmas256 * spread.deviation256) >> 8;
    return {.low = int(std::max<std::int64_t>(divideDown(spread.mean256 - reach + 255, 256), 0)),
        .high = int(std::min<std::int64_t>(divideDown(spread.mean256 + reach, 256), 65535))};
}

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

// Parting a histogram so that the variance between its parts is greatest (Otsu 1979, for several
// thresholds too). It is the same for every machine, since it is worked out in whole numbers:
//
// 1. A part of bins a … b − 1 holds W = Σ n voxels and S = Σ i · n, where n is the count of bin i;
//    it scores ⌊S² / W⌋. Counts are first multiplied by a power of two, or divided by one and
//    rounded down, to at least 1, so that all of them together come near 2³¹.
// 2. Of all ways to part the bins into so many parts, none of them empty, one with the greatest sum
//    of scores is taken; of several, the one whose last part begins first, then the one before it,
//    and so on.
// 3. Where empty bins lie between two parts, the threshold lies in the middle of them.

/// The bins with which all parts but the first begin, ascending.
/// @param thresholds at least 0; fewer come back where fewer parts can be filled
[[nodiscard]] std::vector<std::size_t> otsuBins(
    std::span<const std::uint32_t> counts, int thresholds);

/// The same as values: the lower ends of these bins.
[[nodiscard]] std::vector<double> otsuThresholds(const Histogram& histogram, int thresholds);

} // namespace core

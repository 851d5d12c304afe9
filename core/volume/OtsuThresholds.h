// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

// Divides a histogram so that the variance between its parts is greatest (Otsu 1979, also for
// several thresholds). It is computed in whole numbers, so the result is the same on every machine:
//
// 1. A part of bins a … b − 1 contains W = Σ n voxels and has S = Σ i · n, where n is the count of
//    bin i; its score is ⌊S² / W⌋. First, counts are multiplied by a power of two, or divided by
//    one and rounded down, but to at least 1, so that all of them together come near 2³¹.
// 2. Of all divisions of the bins into the requested number of parts, none of them empty, the one
//    with the greatest sum of scores is taken; if several are equal, the one whose last part begins
//    first, then the one before it, and so on.
// 3. If empty bins lie between two parts, the threshold lies in the middle of them.

/// The first bins of all parts but the first one, ascending.
/// @param thresholds at least 0; fewer are returned if fewer parts can be filled
[[nodiscard]] std::vector<std::size_t> otsuBins(
    std::span<const std::uint32_t> counts, int thresholds);

/// The same as values of the histogram: the lower ends of these bins.
[[nodiscard]] std::vector<double> otsuThresholds(const Histogram& histogram, int thresholds);

} // namespace core

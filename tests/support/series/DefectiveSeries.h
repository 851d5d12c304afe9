// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/series/SyntheticSeries.h"

namespace test {

// Series with a defect whose stored values grow evenly through the patient, so that whatever lies
// between slices is known: 20 per mm of y or z, 3 per column.

/// Every slice @p shiftMm further along y than the one before it; values know x and y alone.
[[nodiscard]] SyntheticSeries tiltedSeries(double shiftMm);
/// Slices at these heights; values know x and z alone.
[[nodiscard]] SyntheticSeries seriesAtHeights(const std::vector<double>& heightsMm);

/// Four more images at the places of slices 2 to 5 (0-based), all of one value, under instance
/// number 99.
void addDoubles(const SyntheticSeries& series, const QString& folder, int stored);

} // namespace test

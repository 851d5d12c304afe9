// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/series/SyntheticSeries.h"

namespace test {

// Series with a defect. Their stored values grow linearly through the patient, so that values
// between slices are known: 20 per mm of y or z, 3 per column.

/// Every slice is @p shiftMm further along y than the one before it; values depend only on x and y.
[[nodiscard]] SyntheticSeries tiltedSeries(double shiftMm);
/// Slices at these heights; values depend only on x and z.
[[nodiscard]] SyntheticSeries seriesAtHeights(const std::vector<double>& heightsMm);

/// Adds four more images at the positions of slices 2 to 5 (0-based), all of one value, with
/// instance number 99.
void addDoubles(const SyntheticSeries& series, const QString& folder, int stored);

} // namespace test

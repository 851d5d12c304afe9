// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// The monotone 16-bit code that stands for a modality value on the GPU (DESIGN §4).
///
/// value(code) = rescaleSlope · (storedAtCodeZero + storedStep · code) + rescaleIntercept, in
/// double: for a series with one slope and intercept whose stored range fits 16 bits this is the
/// very arithmetic of DICOM PS3.3 C.11.1, so the code is exact. Otherwise the series is brought to
/// one common scale and `maxError` states what that costs, in the value's unit.
/// A greater code always means a greater value; storedStep is −1 where the slope is negative.
struct VoxelEncoding {
    double rescaleSlope = 1.0;
    double rescaleIntercept = 0.0;
    int storedAtCodeZero = 0;
    int storedStep = 1;
    double maxError = 0.0; ///< 0: exact

    /// One past the greatest code: the answer "no code qualifies" of the searches below.
    static constexpr int codeCount = 65536;

    [[nodiscard]] double value(int code) const;
    /// Smallest code whose value is ≥ @p bound, by search, never by rounding; codeCount if none.
    [[nodiscard]] int lowestCodeAtLeast(double bound) const;
    /// Greatest code whose value is ≤ @p bound; −1 if none.
    [[nodiscard]] int highestCodeAtMost(double bound) const;
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/MaskOnVolume.h"

#include <vector>

namespace core {

/// A segment of a mask and the one of its reference with which it is compared, by index.
struct SegmentPair {
    std::size_t segment = 0;
    std::size_t reference = 0;
    bool operator==(const SegmentPair&) const = default;
};

/// The names that a user asked for; empty: all that correspond.
struct AskedSegments {
    QString segment;
    QString reference; ///< empty: the one of the same name, or the only one
};

/// Pairs segments of the same name, ignoring case; of several with one name (files of a folder that
/// all call theirs "Label 1") the first with the first, the second with the second. If no name is
/// in both, a single one is paired with a single one, or equally many in their order. The result is
/// in the order of the reference; empty: nothing corresponds, or no segment has a name that was
/// asked for.
[[nodiscard]] std::vector<SegmentPair> segmentPairs(const std::vector<MaskSegment>& mask,
    const std::vector<MaskSegment>& reference, const AskedSegments& asked);

} // namespace core

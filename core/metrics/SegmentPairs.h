// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/MaskOnVolume.h"

#include <vector>

namespace core {

/// Which segment of a mask is compared with which of its reference, by their places.
struct SegmentPair {
    std::size_t segment = 0;
    std::size_t reference = 0;
    bool operator==(const SegmentPair&) const = default;
};

/// The names that a user asked for; empty: whatever belongs together.
struct AskedSegments {
    QString segment;
    QString reference; ///< empty: that of the same name, or the only one there is
};

/// Segments of one name belong together, whatever its letters' case; where no name is in both, a
/// single one belongs to a single one, and as many to as many in their order. In the order of the
/// reference; none: nothing belongs together, or no segment has a name that was asked for.
[[nodiscard]] std::vector<SegmentPair> segmentPairs(const std::vector<MaskSegment>& mask,
    const std::vector<MaskSegment>& reference, const AskedSegments& asked);

} // namespace core

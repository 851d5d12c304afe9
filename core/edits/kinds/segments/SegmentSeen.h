// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/edits/kinds/parts/SegmentChoice.h"

#include <optional>

namespace core {

/// "Segment what I see": what is not carved, inside the clip region and within an interval of
/// values becomes voxels of a segment, from wherever one looks.
struct SegmentSeen {
    SegmentChoice target{};
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    HiddenSides hidden{};
    bool overwriteUnlocked = false;
};

} // namespace core

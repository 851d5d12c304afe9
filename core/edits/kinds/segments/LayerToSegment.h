// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/SegmentChoice.h"

namespace core {

/// What a layer has carved (coverage ≥ 128) becomes voxels of a segment.
struct LayerToSegment {
    int layer = 0; ///< id
    SegmentChoice target{};
    bool overwriteUnlocked = false;
};

} // namespace core

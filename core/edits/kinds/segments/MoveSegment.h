// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Put a segment at another place of the list.
struct MoveSegment {
    int segment = 0; ///< label
    int place = 0; ///< 1: first; beyond the end: last
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// What a segment holds is carved, whole.
struct SegmentToLayer {
    int segment = 0; ///< label
    int layer = 0; ///< id
};

} // namespace core

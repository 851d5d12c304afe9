// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Delete a segment with its voxels, seeds and what has grown from them. Its label is not used
/// again.
struct RemoveSegment {
    int segment = 0; ///< label
};

} // namespace core

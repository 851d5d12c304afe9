// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace peer {

/// What a peer makes of a segment.
struct PeerMask {
    std::vector<std::uint8_t> voxels; ///< 0 or 1, x fastest
    double milliseconds = 0.0; ///< of its filters alone
    /// 1 where either side is right, for the reason of the case; empty: nowhere.
    std::vector<std::uint8_t> either{};
};

} // namespace peer

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstddef>

namespace core {

/// Labels that protect their voxels from carving. A voxel is left as it is if one of the label
/// planes, as it was when the edit began, holds one of these labels there. Refilling
/// (Laying::Refill) ignores it.
struct ProtectedLabels {
    static constexpr std::size_t mostPlanes = 4; ///< as many as there can be
    std::bitset<mostPlanes> planes{1}; ///< the planes that hold protected segments, by number
    std::bitset<256> labels{};
    bool operator==(const ProtectedLabels&) const = default;
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstdint>

namespace core {

/// Labels that protect their voxels from carving. A voxel is left as it is if the label plane, as
/// it was when the edit began, holds one of these labels there. Refilling (Laying::Refill) ignores
/// it.
struct ProtectedLabels {
    std::uint8_t plane = 0;
    std::bitset<256> labels{};
    bool operator==(const ProtectedLabels&) const = default;
};

} // namespace core

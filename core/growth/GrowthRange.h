// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>

namespace core {

/// Which voxels a growth may take at all, whatever else is asked of them. The voxel q is among them
/// if lowCode ≤ code(q) ≤ highCode, and `closed` does not have the label that the label plane holds
/// at q (0: no segment's). For a GrowBurst and a ToleranceRule that is, of a member that growth has
/// added, the label below it, which the plane would hold if the member were given back.
struct GrowthRange {
    int lowCode = 0; ///< greater than highCode: no voxel is among them
    int highCode = 65535;
    std::bitset<256> closed{};
    bool operator==(const GrowthRange&) const = default;
};

} // namespace core

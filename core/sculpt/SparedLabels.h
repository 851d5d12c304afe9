// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bitset>
#include <cstdint>

namespace core {

/// What a cut leaves as it is: the voxels at which a label plane, as it was when the edit began,
/// holds one of these labels. Only carving asks for it; whatever is filled again, is.
struct SparedLabels {
    std::uint8_t plane = 0;
    std::bitset<256> labels{};
    bool operator==(const SparedLabels&) const = default;
};

} // namespace core

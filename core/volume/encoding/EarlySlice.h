// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace core {

/// One slice of a volume whose others are still being decoded, as it will be there: same place,
/// same values, same window.
struct EarlySlice {
    /// Of the whole volume, as headers tell it. `encoding` is that of `codes` below, minimum and
    /// maximum are this slice's; there is neither a histogram nor a checksum yet.
    Volume volume;
    int slice = 0; ///< k: the one in the middle, size.z / 2
    std::vector<std::uint16_t> codes; ///< x fastest, then y
};

/// Told once at most, on a thread of the loader; must return quickly.
using EarlySliceListener = std::function<void(const std::shared_ptr<const EarlySlice>& slice)>;

} // namespace core

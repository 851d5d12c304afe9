// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace core {

/// One slice of a volume whose other slices are still being decoded. Its position, values and
/// window are those that it will have in the volume.
struct EarlySlice {
    /// The whole volume, as described by headers. `encoding` is that of `codes` below, minimum and
    /// maximum are those of this slice; histogram and checksum are not available yet.
    Volume volume;
    int slice = 0; ///< k: the one in the middle, size.z / 2
    std::vector<std::uint16_t> codes; ///< x fastest, then y
};

/// Called at most once, on a thread of the loader; must return quickly.
using EarlySliceListener = std::function<void(const std::shared_ptr<const EarlySlice>& slice)>;

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <cstddef>

namespace core {

/// Whether a volume of so many voxels may be loaded: 2 bytes each within 60 % of the machine's
/// memory. OutOfMemory says how much is wanted and how much there is.
[[nodiscard]] Result<void> checkMemory(std::size_t voxels);

} // namespace core

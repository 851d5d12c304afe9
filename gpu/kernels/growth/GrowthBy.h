// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace gpu {

/// Who moves the front of a growth on, where both can (ProcessorFront). What they write is equal.
enum class GrowthBy : std::uint8_t {
    Driver, ///< the processor with a software driver, kernels with any other
    Kernels,
    Processor,
};

} // namespace gpu

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace gpu {

/// Whether the driver of the current context computes on the processor (Mesa's llvmpipe or
/// softpipe): what it stores then lies in the program's own memory.
[[nodiscard]] bool isSoftwareDriver();

/// Who does what both can do. The results are the same, to the bit.
enum class WorkBy : std::uint8_t {
    Driver, ///< the processor with a software driver, kernels with any other
    Kernels,
    Processor,
};
/// Whether the processor does it, with the driver of the current context.
[[nodiscard]] bool isByProcessor(WorkBy by);

} // namespace gpu

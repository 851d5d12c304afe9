// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace gpu {

/// Whether the driver of the current context computes on the processor (Mesa's llvmpipe or
/// softpipe): what it stores then lies in the program's own memory.
[[nodiscard]] bool isSoftwareDriver();

/// Who does work that kernels and the processor can both do, with the same results to the bit.
enum class WorkBy : std::uint8_t {
    Driver, ///< depends on the driver: the processor with a software driver, else kernels
    Kernels, ///< always kernels
    Processor, ///< always the processor
};
/// Whether the processor does it with the driver of the current context.
[[nodiscard]] bool isByProcessor(WorkBy by);

} // namespace gpu

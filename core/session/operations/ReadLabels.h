// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/operations/OperationQueue.h"

#include <cstdint>
#include <vector>

namespace core {

/// Labels of a plane, or a layer's coverage, as one array, x fastest, behind what waits in
/// @p queue. Waits for the engine.
[[nodiscard]] Result<std::vector<std::uint8_t>> readLabels(
    OperationQueue& queue, std::uint8_t plane, Field field = Field::Labels);

} // namespace core
